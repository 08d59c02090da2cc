// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QStringList>

#include "core/materials/material_formats.h"

/// The table of the formats of materials (core/materials/material_formats.h) in the words of Qt's dialogs and folders.
/// Files are opened by their content, whatever they are called.
namespace gonio::app {

/// "*.binary", "*.bsdf", ..: of what a dialog or a folder of the library shows.
QStringList materialFilePatterns();
/// Of measured materials alone: what a folder gives to a training set.
QStringList measurementFilePatterns();

/// "Materials and documents (..);;All files (*)".
QString materialFilter();
/// The same with a filter for each format between.
QString openFilter();
/// ".binary": with which a format is written.
QString formatSuffix(materials::FormatId format);
/// ".binary": of what the editor writes where nobody chooses a format.
QString tableSuffix();

/// By its suffix: a .gonio document, not a material.
bool isDocument(const QString& path);
QString documentSuffix();

/// "chrome" of "library:merl-copy/chrome" and of "/data/chrome.binary".
QString materialName(const QString& id);
/// Names of several materials, no two equal: those of one name get their source or suffix, "paper_rgl".
QStringList distinctNames(const QStringList& ids);

}  // namespace gonio::app

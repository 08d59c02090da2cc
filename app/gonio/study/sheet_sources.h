// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include "app/gonio/study/contact_sheet_window.h"
#include "core/study/accuracy_study.h"

namespace gonio::app {

class FitRankingModel;
class StudyModel;

/// The preview's subject for a studied representation: its table. Not for the GUI thread. @throws Cancelled.
widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control);

/// The finished fits, as models without the measurement.
SheetSource sheetSource(const QString& name, const LoadedMaterialPtr& material, const FitRankingModel& ranking);
/// The measured representations.
SheetSource sheetSource(const QString& name, const LoadedMaterialPtr& material, const StudyModel& study);

}  // namespace gonio::app

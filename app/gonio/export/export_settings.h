// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>

class QDoubleSpinBox;
class QLabel;

namespace gonio::app {

/// Settings remembered by the export dialogs.
namespace export_settings {
inline const QString target = QStringLiteral("export/target"), snr = QStringLiteral("export/snr"),
                     folder = QStringLiteral("export/folder"), scene = QStringLiteral("export/scene");
}

/// A field for the rendered SNR that files should reach, dB.
QDoubleSpinBox* exportSnrField();
/// A label with text that wraps and can be copied.
QLabel* exportText();

}  // namespace gonio::app

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

#include "app/gonio/window/theme.h"
#include "widgets/parameters/parameter_text.h"

class QComboBox;
class QLabel;
class QSettings;
class QSpinBox;

namespace gonio::app {

class History;

/// Settings for all documents.
struct Preferences {
  Theme theme = Theme::dark;
  int historyMegabytes = 0;  ///< limit of the undo history, per window
  int threads = 0;           ///< for computations; 0: all cores
  widgets::RoughnessDisplay roughness = widgets::RoughnessDisplay::alpha;

  static Preferences read(const QSettings& settings);
  void write(QSettings& settings) const;
  bool operator==(const Preferences&) const = default;
};

/// Limits the threads of all parallel loops of the program; 0: all cores.
void limitThreads(int threads);

/// Applies the stored preferences, except the theme, which main() applies, to the program and a window's history.
void applyPreferences(const QSettings& settings, History& history);
/// Opens the dialog of the preferences; stores and applies what is chosen. @param graphics as for PreferencesDialog.
void showPreferences(QSettings& settings, History& history, const QString& graphics, QWidget* window);

/// Edit > Preferences.
class PreferencesDialog : public QDialog {
  Q_OBJECT

 public:
  /// @param graphics renderer, vendor and version reported by OpenGL.
  PreferencesDialog(const Preferences& preferences, const QString& graphics, QWidget* parent);

  Preferences preferences() const;

 private:
  QWidget* folderRow(const QString& folder);
  void clearThumbnails();
  void showThumbnailSize();

  QComboBox *m_theme, *m_roughness;
  QSpinBox *m_history, *m_threads;
  QLabel* m_thumbnails;
};

}  // namespace gonio::app

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>

#include "app/gonio/document/file_exports.h"
#include "app/gonio/study/sheet_pictures.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/study/contact_sheet.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace gonio::app {

/// The preview's subject for a measured representation: its table. Not for the GUI thread. @throws Cancelled.
widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control);

/// The contact sheet of a study: materials and their representations side by side, in the order of the results, with
/// error maps on a common scale; several materials have a row each. Any two pictures can be compared in the preview,
/// and the whole sheet can be saved.
class StudySheet : public QWidget {
  Q_OBJECT

 public:
  explicit StudySheet(BackgroundTasks& tasks, QWidget* parent = nullptr);
  ~StudySheet() override;

  /// Pictures of materials and entries that remain stay.
  void setSources(std::vector<SheetSource> sources);
  SheetPictures& pictures() { return m_pictures; }
  /// Text shown in place of the tiles.
  void setHint(const QString& text);
  widgets::ContactSheet& sheet() const { return *m_sheet; }
  /// Sets the number of representations that are shown.
  void setCount(int count);
  /// The subject of a picture for the preview: the material (-1), a model, or a table. Not for the GUI thread.
  static widgets::PreviewSubject subjectOf(const SheetSource& source, int entry, const TaskControl& control);
  /// Prepares the two selected tiles for the preview. Precondition: two are selected.
  void compareSelected();

 Q_SIGNALS:
  /// The two subjects are ready. @param names as on the sheet.
  void compareRequested(const std::array<gonio::widgets::PreviewSubject, 2>& subjects,
                        const std::array<QString, 2>& names);
  void saveRequested(const QString& path, const QImage& picture);
  void writeRequested(const QString& path, const gonio::app::FileSave& save);
  void failed(const QString& title, const QString& text);

 private:
  /// A picture of the sheet: entry -1 is the material of the source.
  struct Place {
    std::size_t source;
    int entry;
  };

  void build();
  void showSources();
  void showTiles();
  void showSelection();
  void save();
  void savePdf();
  QString proposedName(const QString& suffix) const;
  int savedColumns() const;

  BackgroundTasks& m_tasks;
  SheetPictures m_pictures;
  QString m_pairKey;            ///< key of its task
  std::vector<Place> m_places;  ///< of the tiles
  widgets::ContactSheet* m_sheet;
  QSpinBox* m_count;
  QCheckBox* m_maps;
  QPushButton *m_compare, *m_save, *m_savePdf;
  QLabel* m_hint;
};

}  // namespace gonio::app

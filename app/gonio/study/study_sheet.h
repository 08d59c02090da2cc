// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <array>
#include <map>
#include <set>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/file_exports.h"
#include "app/gonio/document/loaded_material.h"
#include "core/rendering/render_picture.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/study/contact_sheet.h"

class QCheckBox;
class QLabel;
class QPushButton;
class QSpinBox;

namespace gonio::study {
struct MeasuredRepresentation;
}

namespace gonio::app {

/// The preview's subject for a measured representation: its table. Not for the GUI thread. @throws Cancelled.
widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control);

/// A material and its measured representations, in the order of the sheet.
struct SheetSource {
  QString name;
  LoadedMaterialPtr material;  ///< null: there is nothing to show
  std::vector<std::shared_ptr<const study::MeasuredRepresentation>> entries;
};

/// The contact sheet of a study: the material and its representations side by side, in the order of the results,
/// rendered one after the other in the background, with error maps on a common scale. Any two can be compared in the
/// preview, and the whole sheet can be saved as a picture.
class StudySheet : public QWidget {
  Q_OBJECT

 public:
  explicit StudySheet(BackgroundTasks& tasks, QWidget* parent = nullptr);
  ~StudySheet() override;

  /// Pictures of entries that remain stay.
  void setSource(SheetSource source);
  /// Whether it renders; while not, it shows the pictures that it has. Initially false.
  void setRendering(bool rendering);
  /// Text shown in place of the tiles.
  void setHint(const QString& text);
  widgets::ContactSheet& sheet() const { return *m_sheet; }
  /// Sets the number of representations that are shown.
  void setCount(int count);
  /// Whether all pictures and maps that are shown are finished.
  bool isComplete() const;
  /// The subject of a tile for the preview: the material, a model, or a table. Not for the GUI thread.
  static widgets::PreviewSubject subjectOf(const SheetSource& source, int tile, const TaskControl& control);
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
  using Entry = std::shared_ptr<const study::MeasuredRepresentation>;
  struct Picture {
    Image image;
    QPixmap pixmap, map;
  };
  void build();
  void work();
  void makeMaps();
  void showTiles();
  void save();
  void savePdf();
  int savedColumns() const;
  std::vector<Entry> shownEntries() const;

  BackgroundTasks& m_tasks;
  SheetSource m_source;
  QString m_renderKey, m_mapsKey, m_pairKey;                          ///< keys of its tasks
  std::shared_ptr<const rendering::RenderedComparison> m_comparison;  ///< null until the reference is rendered
  QPixmap m_reference;
  std::map<Entry, Picture> m_pictures;
  std::vector<Entry> m_mapped;  ///< whose maps are on the common scale
  double m_range = 0;
  bool m_rendering = false;
  widgets::ContactSheet* m_sheet;
  QSpinBox* m_count;
  QCheckBox* m_maps;
  QPushButton *m_compare, *m_save, *m_savePdf;
  QLabel* m_hint;
};

}  // namespace gonio::app

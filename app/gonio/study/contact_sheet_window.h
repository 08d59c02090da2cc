// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <array>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/loaded_material.h"
#include "core/rendering/rendered_comparison.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/study/contact_sheet.h"

class QCheckBox;
class QPushButton;
class QSpinBox;

namespace gonio::app {

/// One representation of a material on its way to a sheet, with the numbers of the table that it comes from.
struct SheetEntry {
  QString name, numbers;
  double snr = 0;  ///< rendered, dB: the order of the sheet
  std::shared_ptr<const Brdf> brdf;
  /// For the preview. Not for the GUI thread.
  std::function<widgets::PreviewSubject(const TaskControl&)> subject;
};

struct SheetSource {
  LoadedMaterialPtr material;  ///< what all are compared with
  std::vector<SheetEntry> entries;
};

/// Representations of a material side by side, the best first, behind the material itself: rendered one after the
/// other in the background, with maps of their errors on one scale. Any two go to the preview, and all to a picture.
class ContactSheetWindow : public QDialog {
  Q_OBJECT

 public:
  ContactSheetWindow(BackgroundTasks& tasks, SheetSource source, QWidget* parent);
  ~ContactSheetWindow() override;

  widgets::ContactSheet& sheet() const { return *m_sheet; }
  /// How many representations are shown.
  void setCount(int count);
  /// Whether all pictures and maps are there.
  bool isComplete() const { return m_complete; }
  /// Prepares the two selected tiles for the preview. Contract: two are selected.
  void compareSelected();

 Q_SIGNALS:
  /// Names as on the sheet.
  void compareRequested(const std::array<gonio::widgets::PreviewSubject, 2>& subjects,
                        const std::array<QString, 2>& names);
  void saveRequested(const QString& path, const QImage& picture);
  void failed(const QString& title, const QString& text);

 private:
  void build();
  void start();
  void renderNext();
  void makeMaps();
  void showTiles();
  void save();
  std::size_t shownCount() const;

  BackgroundTasks& m_tasks;
  const SheetSource m_source;
  QString m_renderKey, m_mapsKey, m_pairKey;               ///< of its tasks
  std::shared_ptr<const RenderedComparison> m_comparison;  ///< null until the material is rendered
  std::vector<Image> m_pictures;                           ///< of the entries, as far as they are rendered
  std::vector<widgets::SheetTile> m_tiles;
  double m_range = 0;
  bool m_complete = false;
  widgets::ContactSheet* m_sheet;
  QSpinBox* m_count;
  QCheckBox* m_maps;
  QPushButton *m_compare, *m_save;
};

}  // namespace gonio::app

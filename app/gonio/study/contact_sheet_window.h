// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>
#include <array>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/loaded_material.h"
#include "core/rendering/render_picture.h"
#include "widgets/preview/gl/preview_subject.h"
#include "widgets/study/contact_sheet.h"

class QCheckBox;
class QPushButton;
class QSpinBox;

namespace gonio::app {

/// One representation of a material for a contact sheet, with its numbers from the ranking or study table.
struct SheetEntry {
  QString name, numbers;
  double snr = 0;  ///< rendered SNR, dB; determines the order
  std::shared_ptr<const Brdf> brdf;
  /// Makes the subject for the preview. Not for the GUI thread.
  std::function<widgets::PreviewSubject(const TaskControl&)> subject;
};

struct SheetSource {
  QString name;                ///< of the document
  LoadedMaterialPtr material;  ///< the reference of all entries
  std::vector<SheetEntry> entries;
};

/// The material and its representations side by side, the best first: rendered one after the other in the background,
/// with error maps on a common scale. Any two can be compared in the preview, and the whole sheet can be saved as a
/// picture.
class ContactSheetWindow : public QDialog {
  Q_OBJECT

 public:
  ContactSheetWindow(BackgroundTasks& tasks, SheetSource source, QWidget* parent);
  ~ContactSheetWindow() override;

  widgets::ContactSheet& sheet() const { return *m_sheet; }
  /// Sets the number of representations that are shown.
  void setCount(int count);
  /// Whether all pictures and maps are finished.
  bool isComplete() const { return m_complete; }
  /// Prepares the two selected tiles for the preview. Precondition: two are selected.
  void compareSelected();

 Q_SIGNALS:
  /// The two subjects are ready. @param names as on the sheet.
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
  QString m_renderKey, m_mapsKey, m_pairKey;               ///< keys of its tasks
  std::shared_ptr<const RenderedComparison> m_comparison;  ///< null until the reference is rendered
  std::vector<Image> m_pictures;                           ///< pictures of the entries rendered so far
  std::vector<widgets::SheetTile> m_tiles;
  double m_range = 0;
  bool m_complete = false;
  widgets::ContactSheet* m_sheet;
  QSpinBox* m_count;
  QCheckBox* m_maps;
  QPushButton *m_compare, *m_save;
};

}  // namespace gonio::app

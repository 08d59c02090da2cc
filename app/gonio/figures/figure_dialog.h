// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QDialog>

#include "app/gonio/document/file_exports.h"
#include "app/gonio/figures/figure_materials.h"

class QSettings;

namespace gonio::app {

class FigureFileButtons;
class FigureNumbersList;
class FigurePageSettings;
class FigurePictureSettings;
class FigureRepresentations;
class FigureView;

/// Makes figures for papers: the settings of the figure beside its page. Uses the file formats of goniotool figure.
class FigureDialog : public QDialog {
  Q_OBJECT

 public:
  struct Parts {
    const Document& document;
    FileExports& exports;
    BackgroundTasks& tasks;
    QSettings& settings;
    widgets::LibraryModel& library;
    std::function<QStringList()> selectedIds;  ///< selection of the Library panel
  };
  /// Starts with the open material and the settings of the last figure.
  FigureDialog(const Parts& parts, QWidget* parent);
  ~FigureDialog() override;

  figures::FigureDescription description() const;
  void setDescription(const figures::FigureDescription& description);
  FigureMaterials& materials() const { return *m_materials; }
  FigureRepresentations& representations() const { return *m_representations; }
  FigureNumbersList& numbers() const { return *m_numbers; }
  FigurePictureSettings& pictures() const { return *m_pictures; }
  FigurePageSettings& page() const { return *m_page; }
  FigureView& view() const { return *m_view; }
  FigureFileButtons& files() const { return *m_files; }

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void build();
  QWidget* contentsTab();
  QWidget* appearanceTab();
  void connectParts();
  void restore();
  void remember();
  void update();

  Parts m_parts;
  FigureMaterials* m_materials;
  FigureRepresentations* m_representations;
  FigureNumbersList* m_numbers;
  FigurePictureSettings* m_pictures;
  FigurePageSettings* m_page;
  FigureView* m_view;
  FigureFileButtons* m_files;
};

}  // namespace gonio::app

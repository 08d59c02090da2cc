// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>

#include "app/gonio/document/document.h"
#include "core/figures/figure_description.h"

class QLabel;

namespace gonio::widgets {
class EntryList;
class LibraryModel;
}  // namespace gonio::widgets

namespace gonio::app {

/// The materials of a figure, one per row: the open material, materials of the library, and files. Materials can also
/// be dropped on the list.
class FigureMaterials : public QWidget {
  Q_OBJECT

 public:
  struct Parts {
    const Document& document;
    widgets::LibraryModel& library;
    std::function<QStringList()> selectedIds;  ///< selection of the Library panel
  };
  explicit FigureMaterials(const Parts& parts, QWidget* parent = nullptr);

  const std::vector<figures::FigureMaterial>& materials() const { return m_materials; }
  void setMaterials(std::vector<figures::FigureMaterial> materials);
  /// The id of the open material: its document, otherwise its file or bundled material; empty if it has none.
  QString openId() const;
  widgets::EntryList& list() const { return *m_list; }
  /// Appends files, documents and bundled materials, without those that are already in the list.
  void add(const QStringList& ids);

 Q_SIGNALS:
  void changed();

 protected:
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  bool contains(const QString& id) const;
  void connectList();
  void fillMenu();
  void chooseFromLibrary();
  void chooseFiles();
  void show();
  /// States which part of the open material is not in the figure.
  void showNote();

  Parts m_parts;
  std::vector<figures::FigureMaterial> m_materials;
  widgets::EntryList* m_list;
  QLabel* m_note;
};

}  // namespace gonio::app

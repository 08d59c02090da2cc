// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>

#include "app/gonio/document/document.h"
#include "core/figures/figure_description.h"

class QMenu;
class QLabel;
namespace gonio::widgets {
class EntryList;
}
namespace gonio::widgets {
class EntryList;
class LibraryModel;
}  // namespace gonio::widgets

namespace gonio::app {

class Document;

/// The representations of a figure, one per column: those of the study, with their budgets, and the current fit.
class FigureRepresentations : public QWidget {
  Q_OBJECT

 public:
  explicit FigureRepresentations(const Document& document, QWidget* parent = nullptr);

  const std::vector<figures::FigureRepresentation>& representations() const { return m_representations; }
  void setRepresentations(std::vector<figures::FigureRepresentation> representations);
  /// Sets the default columns: the current fit (or GGX), factors and a code.
  void setDefaults();
  widgets::EntryList& list() const { return *m_list; }

 Q_SIGNALS:
  void changed();

 private:
  void connectList();
  void fillMenu();
  void add(const study::Representation& representation);
  void setBudget(std::size_t row, int budget);
  void show();

  const Document& m_document;
  std::vector<figures::FigureRepresentation> m_representations;
  widgets::EntryList* m_list;
};

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

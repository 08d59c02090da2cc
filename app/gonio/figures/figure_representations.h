// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

#include "core/figures/figure_description.h"

class QMenu;

namespace gonio::widgets {
class EntryList;
}

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

}  // namespace gonio::app

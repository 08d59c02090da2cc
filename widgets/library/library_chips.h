// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "widgets/library/library_order.h"

class QToolButton;

namespace gonio::widgets {

/// A button for each kind and each origin that the library has, and one for the favourites. Those that are pressed say
/// what is shown: of several of one sort any, of two sorts both.
class LibraryChips : public QWidget {
  Q_OBJECT

 public:
  explicit LibraryChips(const LibraryModel& model, QWidget* parent = nullptr);

  const LibraryFilter& filter() const { return m_filter; }
  void clear();
  QToolButton* chip(const QString& text) const;

 Q_SIGNALS:
  void filterChanged();

 private:
  void rebuild();
  void addChip(const QString& text, const QString& toolTip, std::function<void(bool)> toggled);

  const LibraryModel& m_model;
  LibraryFilter m_filter;
  std::vector<QToolButton*> m_chips;
};

}  // namespace gonio::widgets

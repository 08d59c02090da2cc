// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/inputs/flow_layout.h"

#include <QWidget>
#include <algorithm>
#include <utility>
#include <vector>

namespace gonio::widgets {

FlowLayout::FlowLayout(QWidget* parent) : QLayout(parent) {}

FlowLayout::~FlowLayout() = default;

void FlowLayout::addItem(QLayoutItem* item) { m_items.emplace_back(item); }

QLayoutItem* FlowLayout::itemAt(int index) const {
  return index >= 0 && index < count() ? m_items[std::size_t(index)].get() : nullptr;
}

QLayoutItem* FlowLayout::takeAt(int index) {
  if (index < 0 || index >= count()) return nullptr;
  QLayoutItem* item = m_items[std::size_t(index)].release();
  m_items.erase(m_items.begin() + index);
  return item;
}

int FlowLayout::heightForWidth(int width) const { return layOut({0, 0, width, 0}, false); }

QSize FlowLayout::minimumSize() const {
  QSize size;
  for (const auto& item : m_items)
    if (!item->isEmpty()) size = size.expandedTo(item->minimumSize());
  return size.grownBy(contentsMargins());
}

void FlowLayout::setGeometry(const QRect& area) {
  QLayout::setGeometry(area);
  layOut(area, true);
}

int FlowLayout::layOut(const QRect& area, bool place) const {
  const QRect inside = area.marginsRemoved(contentsMargins());
  int x = inside.x(), y = inside.y(), rowHeight = 0;
  std::vector<std::pair<QLayoutItem*, QRect>> row;
  const auto finishRow = [&] {
    for (const auto& [item, rectangle] : row)
      item->setGeometry(rectangle.translated(0, (rowHeight - rectangle.height()) / 2));
    row.clear();
  };
  for (const auto& item : m_items) {
    if (item->isEmpty()) continue;
    const QSize size = item->sizeHint();
    if (x > inside.x() && x + size.width() > inside.x() + inside.width()) {
      finishRow();
      x = inside.x();
      y += rowHeight + spacing();
      rowHeight = 0;
    }
    if (place) row.emplace_back(item.get(), QRect({x, y}, size));
    x += size.width() + spacing();
    rowHeight = std::max(rowHeight, size.height());
  }
  finishRow();
  return y + rowHeight - area.y() + contentsMargins().bottom();
}

}  // namespace gonio::widgets

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QLayout>
#include <memory>
#include <vector>

namespace gonio::widgets {

/// A layout in rows that wrap like words of a paragraph. The height depends on the width.
class FlowLayout : public QLayout {
 public:
  explicit FlowLayout(QWidget* parent = nullptr);
  ~FlowLayout() override;

  void addItem(QLayoutItem* item) override;
  int count() const override { return int(m_items.size()); }
  QLayoutItem* itemAt(int index) const override;
  QLayoutItem* takeAt(int index) override;
  Qt::Orientations expandingDirections() const override { return {}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override;
  QSize sizeHint() const override { return minimumSize(); }
  QSize minimumSize() const override;
  void setGeometry(const QRect& area) override;

 private:
  /// The height of the rows. @param place whether to move the items.
  int layOut(const QRect& area, bool place) const;

  std::vector<std::unique_ptr<QLayoutItem>> m_items;
};

}  // namespace gonio::widgets

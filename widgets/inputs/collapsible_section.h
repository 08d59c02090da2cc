// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QToolButton>
#include <QWidget>

namespace gonio::widgets {

/// A titled section with collapsible content. The header is a button: Tab focuses it, Space toggles.
class CollapsibleSection : public QWidget {
  Q_OBJECT

 public:
  explicit CollapsibleSection(const QString& title, QWidget* content, QWidget* parent = nullptr);

  bool isExpanded() const { return m_header->isChecked(); }
  void setExpanded(bool expanded);

 Q_SIGNALS:
  void expandedChanged(bool expanded);

 private:
  QToolButton* m_header;
  QWidget* m_content;
};

}  // namespace gonio::widgets

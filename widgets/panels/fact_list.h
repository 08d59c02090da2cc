// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QPalette>
#include <QString>
#include <QWidget>
#include <utility>
#include <vector>

class QGridLayout;
class QLabel;

namespace gonio::widgets {

/// A name and a value.
struct Fact {
  QString name, value;
  QString toolTip = {};
};

/// Facts in two aligned columns; the values can be selected and copied.
class FactList : public QWidget {
  Q_OBJECT

 public:
  explicit FactList(QWidget* parent = nullptr);
  /// Replaces all rows. `emptyText` is shown if there are none.
  void setFacts(const std::vector<Fact>& facts, const QString& emptyText = {});

 private:
  QLabel* newLabel(QPalette::ColorRole colour);
  void addRow();

  QGridLayout* m_layout;
  std::vector<std::pair<QLabel*, QLabel*>> m_rows;  ///< name and value; superfluous rows are hidden
  QLabel* m_hint;
};

}  // namespace gonio::widgets

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

class QGridLayout;

namespace gonio::widgets {

/// A name and what is to know.
struct Fact {
  QString name, value;
  QString toolTip = {};
};

/// Facts in two aligned columns; the values can be selected and copied.
class FactList : public QWidget {
  Q_OBJECT

 public:
  explicit FactList(QWidget* parent = nullptr);
  /// Replaces all rows. `emptyText` stands alone when there are none.
  void setFacts(const std::vector<Fact>& facts, const QString& emptyText = {});

 private:
  QGridLayout* m_layout;
};

}  // namespace gonio::widgets

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>
#include <string>
#include <vector>

class QLabel;
class QListWidget;

namespace gonio::app {

/// A list of check boxes that selects the numbers below the pictures of a figure. The numbers appear in the order in
/// which the user checks them.
class FigureNumbersList : public QWidget {
  Q_OBJECT

 public:
  explicit FigureNumbersList(QWidget* parent = nullptr);

  /// Ids of figures::figureNumbers().
  const std::vector<std::string>& numbers() const { return m_numbers; }
  void setNumbers(std::vector<std::string> numbers);
  QListWidget& list() const { return *m_list; }

 Q_SIGNALS:
  void changed();

 private:
  void take(int row, bool isTicked);
  void show();

  std::vector<std::string> m_numbers;
  QListWidget* m_list;
  QLabel* m_order;
};

}  // namespace gonio::app

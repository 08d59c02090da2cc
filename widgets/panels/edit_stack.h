// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace gonio::widgets {

/// One edit of a stack, for people.
struct EditEntry {
  QString name;
  QString toolTip = {};
  double strength = 1;  ///< [0, 1]
  bool enabled = true;

  bool operator==(const EditEntry&) const = default;
};

/// The edits of a document in the order in which they are applied: an eye, the name, the strength as slider and
/// number, a button that deletes. It shows what others own: it tells what the user wants and is told the result by
/// setEntries().
class EditStack : public QWidget {
  Q_OBJECT

 public:
  explicit EditStack(QWidget* parent = nullptr);
  ~EditStack() override;

  /// @param emptyText stands alone when there are none. Rows stay while their count and names do.
  void setEntries(const std::vector<EditEntry>& entries, const QString& emptyText);
  const std::vector<EditEntry>& entries() const { return m_entries; }

 Q_SIGNALS:
  void enabledChosen(int entry, bool enabled);
  /// Everything between these two is one step of the user's hand.
  void editingStarted();
  void strengthEdited(int entry, double strength);
  void editingFinished();
  void deleteRequested(int entry);

 private:
  struct Row;
  void rebuild();

  QVBoxLayout* m_layout;
  QLabel* m_empty;
  std::vector<EditEntry> m_entries;
  std::vector<std::unique_ptr<Row>> m_rows;
};

}  // namespace gonio::widgets

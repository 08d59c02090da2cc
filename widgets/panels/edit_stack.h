// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

class QLabel;
class QLineEdit;
class QToolButton;
class QAction;
class QMenu;

namespace gonio::widgets {

/// One edit of a stack, for display.
struct EditEntry {
  QString name;  ///< shown
  QString toolTip = {};
  double strength = 1;  ///< [0, 1]
  bool enabled = true;
  QString ownName = {};  ///< name given by the user, the initial text of renaming
  QString effect = {};   ///< measured effect, a line below the strength; empty: none

  bool operator==(const EditEntry&) const = default;
  /// Whether all but the strength is equal, which changes with every step of a drag.
  bool hasSameTexts(EditEntry other) const {
    other.strength = strength;
    return *this == other;
  }
};

class NumberField;
class ParameterSlider;

/// One edit of an EditStack: at the top the eye, the name and the Delete button; below them the strength, then the
/// measured effect.
class EditRow : public QWidget {
  Q_OBJECT

 public:
  explicit EditRow(QWidget* parent = nullptr);

  void show(const EditEntry& entry);
  /// Shows a field for the name; Return or leaving the field commits, Escape reverts.
  void beginRename();

 Q_SIGNALS:
  void enabledChosen(bool enabled);
  void editingStarted();
  void strengthEdited(double strength);
  void editingFinished();
  void renamed(const QString& name);
  void deleteRequested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void endRename();
  void elideName();

  QToolButton* m_eye;
  QLabel* m_name;
  QLineEdit* m_nameField;
  ParameterSlider* m_slider;
  NumberField* m_field;
  QToolButton* m_delete;
  QLabel* m_effect;
  std::optional<EditEntry> m_described;  ///< whose texts are shown
};

/// The edits of a document in the order in which they are applied: an eye, the name, the strength as slider and number,
/// a button that deletes. One is selected. Rows can be dragged (or moved by Alt+Up, Alt+Down), renamed (F2 or a
/// double-click on the name), duplicated and added. The widget does not own the edits: it emits the user's requests,
/// and setEntries() shows the result.
class EditStack : public QWidget {
  Q_OBJECT

 public:
  explicit EditStack(QWidget* parent = nullptr);
  ~EditStack() override;

  /// @param selected -1: none. @param emptyText shown if there are no entries. Rows are reused if their number and
  /// names are unchanged.
  void setEntries(const std::vector<EditEntry>& entries, int selected, const QString& emptyText);
  const std::vector<EditEntry>& entries() const { return m_entries; }
  int selected() const;
  /// The menu of the button that adds an edit; the owner fills it.
  QMenu& addMenu() { return *m_addMenu; }
  /// Shows the name of an entry as a field to type in.
  void beginRename(int entry);

 Q_SIGNALS:
  void selectionChosen(int entry);
  void enabledChosen(int entry, bool enabled);
  /// Changes between these two signals are one interaction (one undo step).
  void editingStarted();
  void strengthEdited(int entry, double strength);
  void editingFinished();
  /// @param name empty: remove the user's name.
  void renamed(int entry, const QString& name);
  /// Move the entry `from` to index `to`.
  void moveRequested(int from, int to);
  void duplicateRequested(int entry);
  void deleteRequested(int entry);

 private:
  class List;
  void buildActions();
  void buildButtons();
  void connectRow(EditRow* row, int entry);
  void rebuild();
  void updateActions();

  List* m_list;
  QLabel* m_empty;
  QMenu* m_addMenu;
  QToolButton* m_add;
  QAction *m_rename, *m_duplicate, *m_up, *m_down, *m_delete;
  std::vector<EditEntry> m_entries;
  std::vector<EditRow*> m_rows;  ///< owned by the list
};

}  // namespace gonio::widgets

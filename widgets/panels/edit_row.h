// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace gonio::widgets {

struct EditEntry;
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
  QString m_fullName, m_ownName;
};

}  // namespace gonio::widgets

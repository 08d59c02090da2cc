// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/edit_row.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"
#include "widgets/panels/edit_entry.h"

namespace gonio::widgets {

EditRow::EditRow(QWidget* parent)
    : QWidget(parent),
      m_eye(new QToolButton),
      m_name(new QLabel),
      m_nameField(new QLineEdit),
      m_slider(new ParameterSlider),
      m_field(new NumberField),
      m_delete(new QToolButton),
      m_effect(new QLabel) {
  constexpr double percentScale = 100;
  const int em = fontMetrics().height();
  for (QToolButton* button : {m_eye, m_delete}) {
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
  }
  m_eye->setCheckable(true);
  m_delete->setIcon(glyphIcon(Glyph::close));
  m_name->setTextFormat(Qt::PlainText);
  m_name->setMinimumWidth(1);  // a long name must not widen the whole inspector
  m_nameField->setVisible(false);
  m_nameField->setAccessibleName(tr("Name of the edit"));
  m_nameField->installEventFilter(this);
  m_slider->setRange(0, 1, models::ParameterScale::linear);
  m_slider->setReference(1);
  m_field->setRange(0, 1);
  m_field->setUnit(QStringLiteral("%"), percentScale);
  m_field->setStep(0.01);
  m_field->setFixedWidth(em * 5);
  auto* names = new QHBoxLayout;
  names->setSpacing(0);
  names->addWidget(m_name, 1);
  names->addWidget(m_nameField, 1);
  auto* strength = new QHBoxLayout;
  strength->setSpacing(em / 3);
  strength->addWidget(m_slider, 1);
  strength->addWidget(m_field);
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(em / 4, em / 6, em / 4, em / 4);
  layout->setHorizontalSpacing(em / 3);
  layout->setVerticalSpacing(em / 8);
  layout->setColumnStretch(1, 1);
  layout->addWidget(m_eye, 0, 0);
  layout->addLayout(names, 0, 1);
  layout->addWidget(m_delete, 0, 2);
  layout->addLayout(strength, 1, 1, 1, 2);
  layout->addWidget(m_effect, 2, 1, 1, 2);
  m_effect->setMinimumWidth(1);
  m_effect->setForegroundRole(QPalette::PlaceholderText);
  connect(m_eye, &QToolButton::clicked, this, &EditRow::enabledChosen);
  connect(m_delete, &QToolButton::clicked, this, &EditRow::deleteRequested);
  connect(m_slider, &ParameterSlider::editingStarted, this, &EditRow::editingStarted);
  connect(m_slider, &ParameterSlider::numberEdited, this, &EditRow::strengthEdited);
  connect(m_slider, &ParameterSlider::editingFinished, this, &EditRow::editingFinished);
  connect(m_slider, &ParameterSlider::resetRequested, this, [this] { Q_EMIT strengthEdited(1); });
  connect(m_field, &NumberField::valueEdited, this, &EditRow::strengthEdited);
  connect(m_nameField, &QLineEdit::editingFinished, this, [this] {
    if (m_nameField->isHidden()) return;  // hiding takes the focus and finishes once more
    const QString name = m_nameField->text();
    endRename();
    if (name.trimmed() != m_ownName) Q_EMIT renamed(name.trimmed());
  });
}

void EditRow::show(const EditEntry& entry) {
  m_fullName = entry.name;
  m_ownName = entry.ownName;
  elideName();
  m_name->setToolTip(entry.toolTip);
  m_name->setEnabled(entry.enabled);
  m_eye->setChecked(entry.enabled);
  m_eye->setIcon(glyphIcon(entry.enabled ? Glyph::shown : Glyph::hidden));
  m_eye->setToolTip(entry.enabled ? tr("Excludes this edit from the image, the checks and exports")
                                  : tr("Includes this edit again"));
  m_eye->setAccessibleName(tr("%1 enabled").arg(entry.name));
  m_slider->setNumber(entry.strength);
  m_slider->setModified(entry.strength != 1);
  m_slider->setToolTip(tr("Strength: percentage of the change that is applied"));
  m_slider->setAccessibleName(tr("Strength of %1").arg(entry.name));
  m_field->setValue(entry.strength);
  m_field->setAccessibleName(tr("Strength of %1").arg(entry.name));
  m_effect->setText(entry.effect);
  m_effect->setVisible(!entry.effect.isEmpty());
  m_delete->setToolTip(tr("Deletes this edit"));
  m_delete->setAccessibleName(tr("Delete %1").arg(entry.name));
  for (QWidget* control : std::initializer_list<QWidget*>{m_slider, m_field}) control->setEnabled(entry.enabled);
}

void EditRow::beginRename() {
  m_nameField->setText(m_ownName);
  m_nameField->setPlaceholderText(m_fullName);
  m_name->setVisible(false);
  m_nameField->setVisible(true);
  m_nameField->selectAll();
  m_nameField->setFocus();
}

void EditRow::endRename() {
  m_nameField->setVisible(false);
  m_name->setVisible(true);
}

void EditRow::elideName() {
  m_name->setText(m_name->fontMetrics().elidedText(m_fullName, Qt::ElideRight, std::max(1, m_name->width())));
}

bool EditRow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_nameField && (event->type() == QEvent::KeyPress || event->type() == QEvent::ShortcutOverride) &&
      static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape) {
    event->accept();
    if (event->type() == QEvent::KeyPress) {
      endRename();
      parentWidget()->setFocus();
    }
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void EditRow::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  elideName();
}

}  // namespace gonio::widgets

#include "moc_edit_row.cpp"

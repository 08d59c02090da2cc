// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/panels/edit_stack.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/number_field.h"
#include "widgets/inputs/parameter_slider.h"

namespace gonio::widgets {

namespace {
constexpr double percentScale = 100;
}

struct EditStack::Row {
  explicit Row(EditStack& stack)
      : widget(new QWidget(&stack)),
        eye(new QToolButton),
        name(new QLabel),
        slider(new ParameterSlider),
        field(new NumberField),
        remove(new QToolButton) {
    const int em = widget->fontMetrics().height();
    for (QToolButton* button : {eye, remove}) {
      button->setAutoRaise(true);
      button->setFocusPolicy(Qt::StrongFocus);
    }
    eye->setCheckable(true);
    remove->setIcon(glyphIcon(Glyph::close));
    name->setTextFormat(Qt::PlainText);
    name->setMinimumWidth(1);  // a long name must not widen the whole inspector
    slider->setRange(0, 1, models::ParameterScale::linear);
    slider->setReference(1);
    field->setRange(0, 1);
    field->setUnit(QStringLiteral("%"), percentScale);
    field->setStep(0.01);
    field->setFixedWidth(em * 5);
    auto* layout = new QHBoxLayout(widget);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(em / 3);
    layout->addWidget(eye);
    layout->addWidget(name, 1);
    layout->addWidget(slider, 1);
    layout->addWidget(field);
    layout->addWidget(remove);
  }

  void show(const EditEntry& entry) {
    name->setText(entry.name);
    name->setToolTip(entry.toolTip);
    name->setEnabled(entry.enabled);
    eye->setChecked(entry.enabled);
    eye->setIcon(glyphIcon(entry.enabled ? Glyph::shown : Glyph::hidden));
    eye->setToolTip(entry.enabled ? tr("Leave this edit out of the picture, the checks and exports")
                                  : tr("Let this edit count again"));
    eye->setAccessibleName(tr("%1 is shown").arg(entry.name));
    slider->setNumber(entry.strength);
    slider->setModified(entry.strength != 1);
    slider->setToolTip(tr("How much of the change is added, in percent"));
    slider->setAccessibleName(tr("Strength of %1").arg(entry.name));
    field->setValue(entry.strength);
    field->setAccessibleName(tr("Strength of %1").arg(entry.name));
    remove->setToolTip(tr("Delete this edit"));
    remove->setAccessibleName(tr("Delete %1").arg(entry.name));
    for (QWidget* control : std::initializer_list<QWidget*>{slider, field}) control->setEnabled(entry.enabled);
  }

  QWidget* widget;
  QToolButton* eye;
  QLabel* name;
  ParameterSlider* slider;
  NumberField* field;
  QToolButton* remove;
};

EditStack::EditStack(QWidget* parent) : QWidget(parent), m_layout(new QVBoxLayout(this)), m_empty(new QLabel) {
  m_layout->setContentsMargins(0, 0, 0, 0);
  m_layout->setSpacing(2);
  m_empty->setWordWrap(true);
  m_empty->setForegroundRole(QPalette::PlaceholderText);
  m_layout->addWidget(m_empty);
}

EditStack::~EditStack() = default;

void EditStack::setEntries(const std::vector<EditEntry>& entries, const QString& emptyText) {
  const bool sameRows = std::equal(entries.begin(), entries.end(), m_entries.begin(), m_entries.end(),
                                   [](const EditEntry& a, const EditEntry& b) { return a.name == b.name; });
  m_entries = entries;
  // A slider that is dragged must not be taken out of the hand.
  if (!sameRows) rebuild();
  for (std::size_t i = 0; i < m_rows.size(); ++i) m_rows[i]->show(m_entries[i]);
  m_empty->setText(emptyText);
  m_empty->setVisible(m_entries.empty());
}

void EditStack::rebuild() {
  // A row may be the sender: it goes when its event is done.
  for (const auto& row : m_rows) {
    row->widget->hide();
    row->widget->deleteLater();
  }
  m_rows.clear();
  for (int i = 0; i < int(m_entries.size()); ++i) {
    m_rows.push_back(std::make_unique<Row>(*this));
    const Row& row = *m_rows.back();
    m_layout->addWidget(row.widget);
    connect(row.eye, &QToolButton::clicked, this, [this, i](bool enabled) { Q_EMIT enabledChosen(i, enabled); });
    connect(row.remove, &QToolButton::clicked, this, [this, i] { Q_EMIT deleteRequested(i); });
    connect(row.slider, &ParameterSlider::editingStarted, this, &EditStack::editingStarted);
    connect(row.slider, &ParameterSlider::numberEdited, this, [this, i](double to) { Q_EMIT strengthEdited(i, to); });
    connect(row.slider, &ParameterSlider::editingFinished, this, &EditStack::editingFinished);
    connect(row.slider, &ParameterSlider::resetRequested, this, [this, i] { Q_EMIT strengthEdited(i, 1); });
    connect(row.field, &NumberField::valueEdited, this, [this, i](double to) { Q_EMIT strengthEdited(i, to); });
  }
}

}  // namespace gonio::widgets

#include "moc_edit_stack.cpp"

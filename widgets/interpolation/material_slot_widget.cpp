// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/interpolation/material_slot_widget.h"

#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMimeData>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include "widgets/inputs/icons.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/interpolation/sphere_picture.h"
#include "widgets/library/material_drag.h"

namespace gonio::widgets {

namespace {
constexpr double pictureLines = 3.6;
}

MaterialSlotWidget::MaterialSlotWidget(QChar letter, QWidget* parent)
    : QFrame(parent),
      m_letter(letter),
      m_picture(new QWidget),
      m_name(new QLabel),
      m_note(new QLabel),
      m_current(addButton(tr("Current"), tr("Uses the open material with its current edits"))),
      m_file(addButton(tr("File..."), tr("Opens a material file or a document"))),
      m_clear(addButton({}, {})) {
  m_clear->setIcon(themedIcon(QStringLiteral("close")));
  m_clear->setAutoRaise(true);
  connect(m_current, &QToolButton::clicked, this, &MaterialSlotWidget::currentRequested);
  connect(m_file, &QToolButton::clicked, this, &MaterialSlotWidget::fileRequested);
  connect(m_clear, &QToolButton::clicked, this, &MaterialSlotWidget::clearRequested);
  const int line = fontMetrics().height();
  m_picture->setFixedSize(QSizeF(pictureLines * line, pictureLines * line).toSize());
  m_picture->setAttribute(Qt::WA_TransparentForMouseEvents);
  for (QLabel* label : {m_name, m_note}) {
    label->setTextFormat(Qt::PlainText);
    label->setMinimumWidth(1);  // a long name must not widen the panel
  }
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(2);
  buttons->addWidget(m_current);
  buttons->addWidget(m_file);
  buttons->addWidget(m_clear);
  buttons->addStretch();
  auto* right = new QVBoxLayout;
  right->setSpacing(1);
  right->addWidget(m_name);
  right->addWidget(m_note);
  right->addLayout(buttons);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(5, 4, 5, 4);
  layout->addWidget(m_picture);
  layout->addLayout(right, 1);
  setFocusPolicy(Qt::StrongFocus);
  setAcceptDrops(true);
  setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  setContent({});
}

QToolButton* MaterialSlotWidget::addButton(const QString& text, const QString& toolTip) {
  auto* button = new QToolButton(this);
  button->setText(text);
  button->setToolTip(toolTip);
  button->setFocusPolicy(Qt::StrongFocus);
  return button;
}

void MaterialSlotWidget::setContent(const SlotContent& content) {
  m_content = content;
  setToolTip(content.failed           ? content.toolTip
             : content.name.isEmpty() ? tr("Drop a material from the library or a file here")
                                      : tr("%1\nDrop another one here to replace it").arg(content.toolTip));
  m_clear->setVisible(!content.name.isEmpty() || content.failed || content.removable);
  m_clear->setToolTip(content.removable ? tr("Removes this slot") : tr("Empties this slot"));
  const QString what = content.name.isEmpty() ? tr("empty") : spacedName(content.name);
  setAccessibleName(tr("Material %1: %2").arg(m_letter).arg(what));
  setAccessibleDescription(content.note);
  m_current->setAccessibleName(tr("Material %1: use the open material").arg(m_letter));
  m_file->setAccessibleName(tr("Material %1: from a file").arg(m_letter));
  m_clear->setAccessibleName(tr("Material %1: empty the slot").arg(m_letter));
  showTexts();
  update();
}

void MaterialSlotWidget::setNote(const QString& note) {
  if (note == m_content.note) return;
  m_content.note = note;
  setAccessibleDescription(note);
  showTexts();
}

void MaterialSlotWidget::setCurrentAvailable(bool available) { m_current->setEnabled(available); }

void MaterialSlotWidget::showTexts() {
  const bool empty = m_content.name.isEmpty();
  const int room = std::max(20, width() - m_picture->width() - 3 * fontMetrics().height() / 2);
  const QString name = tr("%1  %2").arg(m_letter).arg(!empty                     ? spacedName(m_content.name)
                                                      : m_content.note.isEmpty() ? tr("empty")
                                                                                 : QString());
  m_name->setText(fontMetrics().elidedText(name, Qt::ElideMiddle, room));
  const QString note = m_content.note.isEmpty() && empty ? tr("Drop a material here") : m_content.note;
  m_note->setText(fontMetrics().elidedText(note, Qt::ElideRight, room));
  m_note->setForegroundRole(m_content.failed ? QPalette::WindowText : QPalette::PlaceholderText);
}

void MaterialSlotWidget::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  showTexts();
}

void MaterialSlotWidget::keyPressEvent(QKeyEvent* event) {
  const bool empties = event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace;
  if (empties && !m_clear->isHidden()) return Q_EMIT clearRequested();
  QFrame::keyPressEvent(event);
}

void MaterialSlotWidget::dragEnterEvent(QDragEnterEvent* event) {
  if (draggedMaterial(event->mimeData()).isEmpty()) return;
  m_dropping = true;
  m_note->setText(tr("Drop to use as material %1").arg(m_letter));
  update();
  event->acceptProposedAction();
}

void MaterialSlotWidget::dragLeaveEvent(QDragLeaveEvent*) {
  m_dropping = false;
  showTexts();
  update();
}

void MaterialSlotWidget::dropEvent(QDropEvent* event) {
  m_dropping = false;
  showTexts();
  update();
  event->acceptProposedAction();
  Q_EMIT materialDropped(draggedMaterial(event->mimeData()));
}

void MaterialSlotWidget::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  const bool marked = m_dropping || hasFocus();
  const bool empty = m_content.name.isEmpty();
  const QColor line = palette().color(marked ? QPalette::Highlight : QPalette::Mid);
  painter.setPen(QPen(line, marked ? 2 : 1, empty && !marked ? Qt::DashLine : Qt::SolidLine));
  painter.setBrush(palette().color(QPalette::Base));
  painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
  paintSphere(painter, m_content.picture, QRectF(m_picture->geometry()), palette());
  if (!m_content.failed) return;
  painter.setPen(palette().color(QPalette::Text));
  const double side = fontMetrics().height() * 1.4;
  const QPointF centre = QRectF(m_picture->geometry()).center();
  paintIcon(painter, QStringLiteral("warning"), {centre.x() - side / 2, centre.y() - side / 2, side, side});
}

}  // namespace gonio::widgets

#include "moc_material_slot_widget.cpp"

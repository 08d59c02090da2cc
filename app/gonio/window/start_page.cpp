// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/start_page.h"

#include <QApplication>
#include <QEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "app/gonio/document/material_files.h"
#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/icons.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/text_sizes.h"

namespace gonio::app {

namespace {

constexpr int maxRecent = 5;
/// Heights of a line.
constexpr QSizeF materialSize(6, 6), kindSize(9.6, 6);
constexpr double maxScale = 2.6;  // the pictures have 256 x 256 and 320 x 200 pixels
/// In heights of a line: the margins, and what stands beside and between the pictures of a row and of a column.
constexpr int pageMargin = 2, besidePictures = 6, betweenPictures = 22;

QFont boldFont(QFont font) {
  font.setBold(true);
  return font;
}

/// The picture of a start page's material has the name of the material.
QString pictureOf(const QString& name) { return QStringLiteral(":/start/%1.jpg").arg(name); }

}  // namespace

StartTile::StartTile(const QString& picture, const QSizeF& size, const QString& name, const QString& sentence)
    : m_picture(picture), m_size(size), m_sentence(sentence) {
  setText(name);
  setAccessibleName(sentence.isEmpty() ? name : tr("%1: %2").arg(name, sentence));
  setFocusPolicy(Qt::StrongFocus);
  setCursor(Qt::PointingHandCursor);
  setAttribute(Qt::WA_Hover);
}

void StartTile::setScale(double scale) {
  if (scale == m_scale) return;
  m_scale = scale;
  updateGeometry();
}

QSize StartTile::pictureSize() const { return (m_size * m_scale * fontMetrics().height()).toSize(); }

QSize StartTile::sizeHint() const {
  const int line = fontMetrics().height();
  // The name on two lines, or on one with a sentence on two.
  return pictureSize() + QSize(line / 2, line * (m_sentence.isEmpty() ? 11 : 15) / 4);
}

void StartTile::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const int line = fontMetrics().height(), margin = line / 4;
  constexpr double radius = 6;
  if (underMouse() || isDown()) {
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(isDown() ? QPalette::Mid : QPalette::Button));
    painter.drawRoundedRect(rect(), radius, radius);
  }
  const QRect area({margin, margin}, pictureSize());
  QPainterPath frame;
  frame.addRoundedRect(area, radius, radius);
  painter.setClipPath(frame);
  const QSize pixels = pictureSize() * devicePixelRatioF();
  painter.drawPixmap(area, widgets::scaledPixmap(m_picture, pixels));
  painter.setClipping(false);
  if (hasFocus()) {
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(rect().adjusted(1, 1, -1, -1), radius, radius);
  }
  const QRect below(margin, area.bottom() + margin, area.width(), height() - area.bottom() - margin);
  painter.setPen(palette().color(QPalette::WindowText));
  if (m_sentence.isEmpty()) {
    painter.drawText(below, Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap, text());
    return;
  }
  painter.setFont(boldFont(font()));
  painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, text());
  painter.setFont(font());
  painter.setPen(palette().color(QPalette::PlaceholderText));
  painter.drawText(below.adjusted(0, line, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_sentence);
}

QStringList StartPage::materials() {
  return {QStringLiteral("library:rgl/cc_iris_purple_gem"),  QStringLiteral("library:merl-copy/gold-metallic-paint"),
          QStringLiteral("library:rgl/cc_ibiza_sunset"),     QStringLiteral("library:rgl/chm_light_blue"),
          QStringLiteral("library:rgl/acrylic_felt_purple"), QStringLiteral("library:rgl/leaf_maple")};
}

StartPage::StartPage(const RecentFiles& recent, QWidget* parent)
    : QWidget(parent), m_recent(recent), m_title(new QLabel), m_open(new QPushButton), m_recentBox(new QWidget) {
  setAutoFillBackground(true);
  setAttribute(Qt::WA_NoMousePropagation);  // the view below does not turn
  auto* content = new QWidget;
  m_column = new QVBoxLayout(content);
  const int line = fontMetrics().height();
  m_column->setSpacing(line / 2);
  m_title->setFont(widgets::sized(font(), widgets::TextSize::large));
  m_title->setTextFormat(Qt::PlainText);
  m_title->setWordWrap(true);
  m_open->setText(tr("Open..."));
  m_open->setToolTip(tr("Opens a material or a document (Ctrl+O); a file can also be dropped here"));
  connect(m_open, &QPushButton::clicked, this, &StartPage::fileRequested);
  m_column->addWidget(m_title);
  m_column->addWidget(m_open, 0, Qt::AlignLeft);
  auto* recentRows = new QVBoxLayout(m_recentBox);
  recentRows->setContentsMargins(0, 0, 0, 0);
  recentRows->setSpacing(0);
  m_column->addWidget(m_recentBox);
  addHeading(tr("Try a material"));
  addMaterials();
  addHeading(tr("Three ways to edit"));
  addKinds();
  m_column->addStretch();
  auto* scroll = new QScrollArea(this);
  scroll->setWidget(content);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setFocusPolicy(Qt::NoFocus);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(scroll);
  setOpening({});
  setGeometry(parent->rect());
  parent->installEventFilter(this);
}

void StartPage::addHeading(const QString& text) {
  auto* heading = new QLabel(text);
  heading->setFont(boldFont(font()));
  heading->setContentsMargins(0, fontMetrics().height() / 2, 0, 0);
  m_column->addWidget(heading);
}

void StartPage::addMaterials() {
  auto* tiles = new QWidget;
  auto* flow = new widgets::FlowLayout(tiles);
  flow->setContentsMargins(0, 0, 0, 0);
  for (const QString& id : materials()) {
    const QString name = materialName(id);
    auto* tile = new StartTile(pictureOf(name), materialSize, widgets::spacedName(name).replace('-', ' '));
    tile->setToolTip(tr("Opens %1 from the bundled library").arg(name));
    connect(tile, &StartTile::clicked, this, [this, id] { Q_EMIT openRequested(id); });
    flow->addWidget(tile);
  }
  m_column->addWidget(tiles);
}

void StartPage::addKinds() {
  auto* tiles = new QWidget;
  auto* flow = new widgets::FlowLayout(tiles);
  flow->setContentsMargins(0, 0, 0, 0);
  const std::tuple<EditingKind, QString, const char*, QString> kinds[] = {
      {EditingKind::sliders, tr("Sliders"), "sliders", tr("Set roughness, strength and colour.")},
      {EditingKind::curves, tr("Curves"), "curves", tr("Draw the shape of the highlight.")},
      {EditingKind::blend, tr("Blend"), "blend", tr("Mix two to four materials.")}};
  for (const auto& [kind, name, picture, sentence] : kinds) {
    auto* tile = new StartTile(pictureOf(QString::fromLatin1(picture)), kindSize, name, sentence);
    connect(tile, &StartTile::clicked, this, [this, kind = kind] { Q_EMIT kindRequested(kind); });
    flow->addWidget(tile);
  }
  m_column->addWidget(tiles);
}

void StartPage::showRecent() {
  qDeleteAll(m_recentBox->findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly));
  for (const QString& path : m_recent.paths().mid(0, maxRecent)) {
    auto* button = new QToolButton;
    button->setText(widgets::menuText(path.section('/', -1)));
    button->setToolTip(path);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    button->setCursor(Qt::PointingHandCursor);
    button->setEnabled(RecentFiles::exists(path));
    connect(button, &QToolButton::clicked, this, [this, path] { Q_EMIT openRequested(path); });
    m_recentBox->layout()->addWidget(button);
  }
  m_recentBox->setVisible(!m_recent.paths().isEmpty());
}

void StartPage::setWanted(bool wanted) {
  if (wanted && isHidden()) showRecent();
  // What is shown next has the keys that the page had.
  const bool hadFocus = isAncestorOf(QApplication::focusWidget());
  setVisible(wanted);
  if (!wanted && hadFocus) parentWidget()->setFocus(Qt::OtherFocusReason);
  if (wanted) raise();
}

void StartPage::setOpening(const QString& name) {
  m_title->setText(name.isEmpty() ? tr("Open a material to start") : tr("Opening %1...").arg(name));
}

/// Pictures as large as a row of all materials and the two rows of pictures permit; the page is in the middle.
void StartPage::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  const int line = fontMetrics().height();
  const double across = double(width()) / line - 2 * pageMargin - besidePictures,
               down = double(height()) / line - betweenPictures;
  const double scale = std::clamp(
      std::min(across / (double(materials().size()) * materialSize.width()), down / (2 * materialSize.height())), 1.0,
      maxScale);
  for (StartTile* tile : findChildren<StartTile*>()) tile->setScale(scale);
  const double row = double(materials().size()) * scale * materialSize.width() + besidePictures;
  const int beside = std::max(pageMargin * line, int(width() - row * line) / 2);
  m_column->setContentsMargins(beside, pageMargin * line, pageMargin * line, pageMargin * line);
}

bool StartPage::eventFilter(QObject*, QEvent* event) {
  if (event->type() == QEvent::Resize) setGeometry(parentWidget()->rect());
  return false;
}

}  // namespace gonio::app

#include "moc_start_page.cpp"

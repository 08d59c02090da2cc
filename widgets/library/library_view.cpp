// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_view.h"

#include <QComboBox>
#include <QDragEnterEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QPainter>
#include <QScrollBar>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>
#include <cmath>

#include "core/math/types.h"
#include "widgets/inputs/icons.h"
#include "widgets/inputs/text_sizes.h"
#include "widgets/library/library_chips.h"
#include "widgets/library/library_model.h"
#include "widgets/library/library_selection.h"
#include "widgets/panels/elided_label.h"

namespace gonio::widgets {

namespace {
constexpr int margin = 4, labelLines = 2;

/// A grey disc of a picture that is still to be made; crossed out where the file cannot be read.
void paintPlaceholder(QPainter& painter, const QRectF& area, QColor colour, bool failed) {
  colour.setAlphaF(0.12f);
  painter.setBrush(colour);
  painter.setPen(Qt::NoPen);
  const double inset = area.width() * 0.1;
  painter.drawEllipse(area.adjusted(inset, inset, -inset, -inset));
  if (!failed) return;
  painter.setPen(QPen(QColor(200, 60, 50), std::max(2.0, area.width() / 32), Qt::SolidLine, Qt::RoundCap));
  const double reach = area.width() * 0.16;
  const QPointF middle = area.center(), along(reach, reach), across(reach, -reach);
  painter.drawLine(middle - along, middle + along);
  painter.drawLine(middle - across, middle + across);
}

constexpr int labelFlags = Qt::AlignHCenter | Qt::AlignTop | Qt::TextWordWrap;

/// The name in at most two lines: "blue-metallic-paint" may break after a hyphen. What has
/// no room is left out in the middle: the end of a name, such as ", rougher", distinguishes it.
QString shownName(const QString& name, const QFontMetrics& metrics, const QRect& label) {
  constexpr double fullest = 2, emptiest = 1, step = 0.1;  // of lines: words leave some of the first one empty
  for (double lines = fullest;; lines -= step) {
    const QString shown = metrics.elidedText(name, Qt::ElideMiddle, int(lines * label.width()))
                              .replace('-', QStringLiteral("-") + QChar(0x200b));
    const QRect needed = metrics.boundingRect(label, labelFlags, shown);
    if (lines <= emptiest || (needed.height() <= label.height() && needed.width() <= label.width())) return shown;
  }
}

/// A ground that is lighter than the list in a dark theme: black materials would vanish.
void paintGround(QPainter& painter, const QRect& picture, QColor colour) {
  constexpr float faint = 0.08f;
  colour.setAlphaF(faint);
  painter.setPen(Qt::NoPen);
  painter.setBrush(colour);
  painter.drawRoundedRect(picture, margin, margin);
}

void paintHeading(QPainter& painter, const QStyleOptionViewItem& option, const QString& title) {
  QFont font = option.font;
  font.setBold(true);
  painter.setFont(font);
  painter.setPen(option.palette.color(QPalette::Text));
  const QRect area = option.rect.adjusted(margin, 0, -margin, -margin / 2);
  painter.drawText(area, Qt::AlignLeft | Qt::AlignVCenter,
                   QFontMetrics(font).elidedText(title, Qt::ElideRight, area.width()));
  QColor line = option.palette.color(QPalette::Text);
  line.setAlphaF(0.25f);
  painter.setPen(line);
  painter.drawLine(area.bottomLeft(), area.bottomRight());
}

/// A text on a ground of its own, legible on any picture.
void paintPill(QPainter& painter, const QStyleOptionViewItem& option, const QRect& pill, const QFont& font,
               const QString& text) {
  // Grey against the list: in the list's own colour the text would look like a hole in the picture.
  QColor ground = option.palette.color(QPalette::Window).darker(108);
  ground.setAlphaF(0.92f);
  painter.setPen(Qt::NoPen);
  painter.setBrush(ground);
  painter.drawRoundedRect(pill, pill.height() / 2.0, pill.height() / 2.0);
  painter.setPen(option.palette.color(QPalette::Text));
  painter.setFont(font);
  painter.drawText(pill, Qt::AlignCenter, text);
}

/// A quiet word below the name.
void paintBadge(QPainter& painter, const QStyleOptionViewItem& option, const QRect& line, const QString& badge) {
  const QFont font = sized(option.font, TextSize::small);
  painter.setFont(font);
  painter.setPen(option.palette.color(QPalette::PlaceholderText));
  painter.drawText(line, Qt::AlignHCenter | Qt::AlignTop,
                   QFontMetrics(font).elidedText(badge, Qt::ElideRight, line.width()));
}

/// "4" and a star in the upper left corner of the picture.
void paintRating(QPainter& painter, const QStyleOptionViewItem& option, const QRect& picture, int rating) {
  const QString text = QString::number(rating) + QChar(0x2605);
  const QSize size(option.fontMetrics.horizontalAdvance(text) + margin, option.fontMetrics.height());
  paintPill(painter, option, {picture.topLeft(), size}, option.font, text);
}

/// A star in the upper right corner of the picture.
void paintStar(QPainter& painter, const QStyleOptionViewItem& option, const QRect& picture) {
  const double radius = option.fontMetrics.height() * 0.45;
  const QPointF middle(picture.right() - radius - margin, picture.top() + radius + margin);
  QPolygonF star;
  constexpr double inner = 0.42;
  for (int i = 0; i < 10; ++i) {
    const double angle = i * pi / 5, reach = radius * (i % 2 ? inner : 1);
    star << middle + reach * QPointF(std::sin(angle), -std::cos(angle));
  }
  painter.setPen(QPen(option.palette.color(QPalette::Base), 1.5));
  painter.setBrush(QColor(235, 170, 30));
  painter.drawPolygon(star);
}

}  // namespace

QSize LibraryDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const auto* view = qobject_cast<const QListView*>(option.widget);
  const int spacing = view ? view->spacing() : 0;
  const int narrowest = m_tile + 2 * margin;
  // A row of its own: as wide as the view.
  if (index.data(LibraryModel::HeadingRole).toBool())
    return {view ? view->viewport()->width() - 2 * spacing - 1 : m_tile, option.fontMetrics.height() + 3 * margin};
  // The columns share the width: a strip on the right would be lost for the names. The scroll bar has its place whether
  // it is there or not; the view lays out its items before it knows.
  const int bar = view ? view->verticalScrollBar()->sizeHint().width() : 0;
  const int room = view ? view->maximumViewportSize().width() - bar - spacing - 1 : narrowest;
  const int columns = std::max(1, room / (narrowest + spacing));
  return {std::max(narrowest, room / columns - spacing),
          m_tile + labelLines * option.fontMetrics.height() +
              QFontMetrics(sized(option.font, TextSize::small)).height() + 3 * margin};
}

void LibraryDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  painter->save();
  painter->setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  if (index.data(LibraryModel::HeadingRole).toBool())
    paintHeading(*painter, option, index.data().toString());
  else
    paintTile(painter, option, index);
  painter->restore();
}

void LibraryDelegate::paintTile(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const QRectF tile = QRectF(option.rect).adjusted(1.5, 1.5, -1.5, -1.5);
  const bool selected = option.state & QStyle::State_Selected, hovered = option.state & QStyle::State_MouseOver;
  const bool focused = option.state & QStyle::State_HasFocus;
  const QColor accent = option.palette.color(QPalette::Highlight), text = option.palette.color(QPalette::Text);
  if (selected || hovered) {
    QColor fill = selected ? accent : text;
    fill.setAlphaF(selected ? 0.28f : 0.07f);
    painter->setPen(Qt::NoPen);
    painter->setBrush(fill);
    painter->drawRoundedRect(tile, 5, 5);
  }
  if (focused || selected) {
    painter->setBrush(Qt::NoBrush);
    painter->setPen(QPen(accent, focused ? 2 : 1));
    painter->drawRoundedRect(tile, 5, 5);
  }
  const QRect picture(option.rect.left() + (option.rect.width() - m_tile) / 2, option.rect.top() + margin, m_tile,
                      m_tile);
  const QPixmap pixmap = index.data(Qt::DecorationRole).value<QPixmap>();
  const bool failed = !index.data(LibraryModel::FailureRole).toString().isEmpty();
  paintGround(*painter, picture, text);
  if (pixmap.isNull())
    paintPlaceholder(*painter, picture, text, failed);
  else
    painter->drawPixmap(picture, scaledPixmap(pixmap, QSize(m_tile, m_tile) * painter->device()->devicePixelRatioF()));

  const QRect label(option.rect.left() + margin / 2, picture.bottom() + margin, option.rect.width() - margin,
                    labelLines * option.fontMetrics.height());
  painter->setPen(text);
  painter->setFont(option.font);
  const QString name = shownName(index.data().toString(), option.fontMetrics, label);
  painter->drawText(label, labelFlags, name);
  // Directly below the name, of one line or two.
  const int nameHeight = option.fontMetrics.boundingRect(label, labelFlags, name).height();
  const QRect badge(label.left(), label.top() + std::min(nameHeight, label.height()), label.width(),
                    option.rect.bottom() - label.top() - nameHeight);
  paintBadge(*painter, option, badge,
             index.data(failed ? LibraryModel::FailureBadgeRole : LibraryModel::BadgeRole).toString());
  if (index.data(LibraryModel::FavouriteRole).toBool()) paintStar(*painter, option, picture);
  if (const int rating = index.data(LibraryModel::RatingRole).toInt(); rating > 0)
    paintRating(*painter, option, picture, rating);
}

namespace {
constexpr int minTile = 64, maxTile = 256, defaultTile = 88;
constexpr int visibleDelayMilliseconds = 60, similarityMode = 4;
}  // namespace

LibraryView::LibraryView(LibraryModel* model, QWidget* parent)
    : QWidget(parent),
      m_model(model),
      m_proxy(new LibraryOrder(model, this)),
      m_delegate(new LibraryDelegate(this)),
      m_title(new ElidedLabel(this)),
      m_search(new QLineEdit(this)),
      m_chips(new LibraryChips(*model, this)),
      m_filter(new QToolButton(this)),
      m_group(new QComboBox(this)),
      m_sort(new QComboBox(this)),
      m_list(new QListView(this)),
      m_empty(new QLabel(m_list)),
      m_size(new QSlider(Qt::Horizontal, this)) {
  setAcceptDrops(true);
  buildControls();
  connectList();

  auto* top = new QHBoxLayout;
  top->addWidget(m_search, 1);
  top->addWidget(m_filter);
  auto* order = new QHBoxLayout;
  order->addWidget(m_group, 1);
  order->addWidget(m_sort, 1);
  auto* bottom = new QHBoxLayout;
  bottom->addWidget(m_title, 1);
  bottom->addWidget(m_size);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(m_chips);
  layout->addLayout(order);
  layout->addWidget(m_list, 1);
  layout->addLayout(bottom);
  setTileSize(defaultTile);
  setSortMode(0);
}

void LibraryView::buildControls() {
  m_search->setPlaceholderText(tr("Search materials"));
  m_search->setAccessibleName(tr("Search materials"));
  m_search->setClearButtonEnabled(true);
  m_search->addAction(themedIcon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  m_search->installEventFilter(this);
  connect(m_search, &QLineEdit::textChanged, this, [this](const QString& text) {
    m_proxy->setSearch(text);
    updateEmptyState();
    m_visibleTimer.start();
  });
  m_search->setToolTip(tr("Searches the names, kinds, badges, sources and tags for all words, in any order"));
  m_filter->setText(tr("Filter"));
  m_filter->setCheckable(true);
  m_filter->setFocusPolicy(Qt::StrongFocus);
  m_filter->setToolTip(tr("Shows the filter buttons; when off, all materials are shown"));
  connect(m_filter, &QToolButton::toggled, this, &LibraryView::setChipsShown);
  connect(m_chips, &LibraryChips::filterChanged, this, &LibraryView::filterChanged);
  m_chips->hide();
  m_group->addItems({tr("No groups"), tr("By source"), tr("By kind")});
  m_group->setAccessibleName(tr("Group by"));
  m_group->setToolTip(tr("Groups the materials by source or by kind"));
  connect(m_group, &QComboBox::currentIndexChanged, this, &LibraryView::setGrouping);
  m_sort->addItems(
      {tr("Name"), tr("Hue"), tr("Roughness"), tr("Lightness"), tr("Similarity"), tr("Rating"), tr("Last opened")});
  m_sort->setAccessibleName(tr("Sort by"));
  m_sort->setToolTip(tr("Sorts the materials within their groups"));
  m_sort->setItemData(similarityMode,
                      tr("Sorts by similarity to the open material: mean colour of the thumbnails, and roughness"),
                      Qt::ToolTipRole);
  connect(m_sort, &QComboBox::currentIndexChanged, this, &LibraryView::setSortMode);

  m_size->setRange(minTile, maxTile);
  m_size->setAccessibleName(tr("Thumbnail size"));
  m_size->setToolTip(tr("Thumbnail size"));
  m_size->setFixedWidth(fontMetrics().height() * 6);
  connect(m_size, &QSlider::valueChanged, this, &LibraryView::setTileSize);
  m_title->setForegroundRole(QPalette::PlaceholderText);

  m_empty->setAlignment(Qt::AlignCenter);
  m_empty->setWordWrap(true);
  m_empty->setForegroundRole(QPalette::PlaceholderText);
  auto* over = new QVBoxLayout(m_list->viewport());
  over->addWidget(m_empty);
}

void LibraryView::connectList() {
  m_list->setModel(m_proxy);
  m_list->setItemDelegate(m_delegate);
  m_list->setViewMode(QListView::IconMode);
  m_list->setResizeMode(QListView::Adjust);
  m_list->setMovement(QListView::Static);
  m_list->setDragEnabled(true);
  m_list->setDragDropMode(QAbstractItemView::DragOnly);
  m_list->setSpacing(2);
  m_list->setMouseTracking(true);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_list->setAccessibleName(tr("Materials"));
  m_list->viewport()->installEventFilter(this);
  m_selection = new LibrarySelection(*m_list, *m_model, *this);

  m_visibleTimer.setSingleShot(true);
  m_visibleTimer.setInterval(visibleDelayMilliseconds);
  connect(&m_visibleTimer, &QTimer::timeout, this, [this] { Q_EMIT visibleIdsChanged(visibleIds()); });
  const auto later = [this] { m_visibleTimer.start(); };
  connect(m_list->verticalScrollBar(), &QScrollBar::valueChanged, this, later);
  connect(m_proxy, &QAbstractItemModel::modelReset, this, [this] {
    updateEmptyState();
    m_visibleTimer.start();
  });
}

void LibraryView::setChipsShown(bool shown) {
  m_filter->setChecked(shown);
  m_chips->setVisible(shown);
  if (!shown) m_chips->clear();
}

bool LibraryView::chipsShown() const { return m_filter->isChecked(); }

void LibraryView::filterChanged() {
  m_proxy->setFilter(m_chips->filter());
  updateEmptyState();
  m_visibleTimer.start();
}

void LibraryView::dragEnterEvent(QDragEnterEvent* event) { event->setAccepted(event->source() == m_list); }

bool LibraryView::eventFilter(QObject* watched, QEvent* event) {
  if (watched == m_list->viewport() && (event->type() == QEvent::Resize || event->type() == QEvent::Show))
    m_visibleTimer.start();
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const int key = static_cast<QKeyEvent*>(event)->key();
  const bool enter = key == Qt::Key_Return || key == Qt::Key_Enter;
  // From the search field: Down goes into the grid, Enter opens the first match.
  if (watched == m_search && (key == Qt::Key_Down || enter)) {
    if (!m_list->currentIndex().isValid() || enter) m_selection->selectOutermost(true);
    m_list->setFocus();
    if (enter) m_selection->openCurrent();
    return true;
  }
  return QWidget::eventFilter(watched, event);
}

void LibraryView::setTitle(const QString& title) {
  m_title->setText(title);
  m_title->setToolTip(title);
}

void LibraryView::setEmptyText(const QString& text) {
  m_emptyText = text;
  updateEmptyState();
}

void LibraryView::updateEmptyState() {
  m_empty->setText(m_model->isListing()         ? tr("Listing the folder...")
                   : m_model->rowCount() == 0   ? m_emptyText
                   : m_search->text().isEmpty() ? tr("No material matches the filter.")
                                                : tr("No material matches \"%1\".").arg(m_search->text()));
  m_empty->setVisible(m_proxy->rowCount() == 0);
}

void LibraryView::setTileSize(int pixels) {
  m_size->setValue(pixels);
  m_delegate->setTileSize(m_size->value());
  m_list->setGridSize({});
  m_list->doItemsLayout();
  m_visibleTimer.start();
}

int LibraryView::tileSize() const { return m_size->value(); }

void LibraryView::setSortMode(int mode) {
  m_sort->setCurrentIndex(mode);
  constexpr int roles[] = {Qt::DisplayRole,
                           LibraryModel::HueRole,
                           LibraryModel::RoughnessRole,
                           LibraryModel::LightnessRole,
                           LibraryModel::DissimilarityRole,
                           LibraryModel::RatingOrderRole,
                           LibraryModel::OpenedOrderRole};
  m_proxy->setSortRole(roles[m_sort->currentIndex()]);
  m_proxy->sort(0);
  m_visibleTimer.start();
}

void LibraryView::setGrouping(int grouping) {
  m_group->setCurrentIndex(grouping);
  m_proxy->setGrouping(LibraryGrouping(m_group->currentIndex()));
  m_visibleTimer.start();
}

int LibraryView::grouping() const { return m_group->currentIndex(); }

int LibraryView::sortMode() const { return m_sort->currentIndex(); }

QStringList LibraryView::visibleIds() const {
  QStringList ids;
  const QRect area = m_list->viewport()->rect();
  for (int row = 0; row < m_proxy->rowCount(); ++row) {
    const QModelIndex index = m_proxy->index(row, 0);
    if (!(index.flags() & Qt::ItemIsEnabled)) continue;
    if (m_list->visualRect(index).intersects(area)) ids << index.data(LibraryModel::IdRole).toString();
  }
  return ids;
}

}  // namespace gonio::widgets

#include "moc_library_view.cpp"

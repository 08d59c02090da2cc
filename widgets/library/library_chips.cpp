// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_chips.h"

#include <QEvent>
#include <QHash>
#include <QRegularExpression>
#include <QToolButton>
#include <algorithm>
#include <utility>

#include "widgets/inputs/flow_layout.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::widgets {

namespace {

/// "red", "metallic", "paint2" of "Red-metallic_paint2".
QStringList wordsOf(const QString& text) {
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}]+"));
  return text.toLower().split(between, Qt::SkipEmptyParts);
}

/// Words of which hyphens are a part.
QStringList termsOf(const QString& text) {
  static const QRegularExpression between(QStringLiteral("[^\\p{L}\\p{N}-]+"));
  return text.toLower().split(between, Qt::SkipEmptyParts);
}

}  // namespace

LibraryOrder::LibraryOrder(LibraryModel* model, QObject* parent) : QSortFilterProxyModel(parent), m_model(model) {
  setSourceModel(model);
  setSortCaseSensitivity(Qt::CaseInsensitive);
  // A note may change which quality of a material matches.
  connect(model, &LibraryModel::notesChanged, this, [this] { invalidateFilter(); });
}

void LibraryOrder::setGrouping(LibraryGrouping grouping) {
  m_grouping = grouping;
  invalidate();
}

void LibraryOrder::setSearch(const QString& text) {
  m_words = text.toLower().split(' ', Qt::SkipEmptyParts);
  invalidateFilter();
}

void LibraryOrder::setFilter(const LibraryFilter& filter) {
  if (filter == m_filter) return;
  m_filter = filter;
  invalidateFilter();
}

bool LibraryOrder::matches(int row) const {
  const QModelIndex index = m_model->index(row);
  const QString badge = index.data(LibraryModel::BadgeRole).toString();
  const QString kind = m_model->group(row, LibraryGrouping::kind);
  if (m_filter.favourites && !index.data(LibraryModel::FavouriteRole).toBool()) return false;
  if (!m_filter.badges.isEmpty() && !m_filter.badges.contains(badge)) return false;
  if (!m_filter.kinds.isEmpty() && !m_filter.kinds.contains(kind)) return false;
  const QStringList tags = index.data(LibraryModel::TagsRole).toStringList();
  const auto isTagged = [&](const QString& tag) { return tags.contains(tag); };
  if (!m_filter.tags.isEmpty() && std::ranges::none_of(m_filter.tags, isTagged)) return false;
  constexpr int recentDays = 7;
  const QDateTime opened = index.data(LibraryModel::OpenedRole).toDateTime();
  if (m_filter.recent && (opened.isNull() || opened.daysTo(QDateTime::currentDateTime()) > recentDays)) return false;
  if (m_words.isEmpty()) return true;
  const QStringList own = wordsOf(
      QStringList{index.data().toString(), kind, tags.join(' '), index.data(LibraryModel::LookRole).toString()}.join(
          ' '));
  // A badge is one term: "measured" does not match "near-measured copy".
  const QStringList origin = termsOf(badge + ' ' + m_model->group(row, LibraryGrouping::source));
  const auto begins = [](const QStringList& all, const QString& word) {
    return std::ranges::any_of(all, [&](const QString& one) { return one.startsWith(word); });
  };
  return std::ranges::all_of(m_words, [&](const QString& word) {
    const QStringList parts = wordsOf(word);
    return begins(origin, word) || std::ranges::all_of(parts, [&](const QString& part) { return begins(own, part); });
  });
}

bool LibraryOrder::isBest(int row) const {
  if (!matches(row)) return false;
  const std::vector<int> qualities = m_model->qualities(row);
  return *std::ranges::find_if(qualities, [&](int other) { return other == row || matches(other); }) == row;
}

bool LibraryOrder::filterAcceptsRow(int row, const QModelIndex&) const {
  const LibraryGrouping heading = m_model->headingOf(row);
  if (heading == LibraryGrouping::none) return isBest(row);
  if (heading != m_grouping) return false;
  const QString title = m_model->group(row, heading);
  for (int other = 0; other < m_model->rowCount(); ++other)
    if (m_model->headingOf(other) == LibraryGrouping::none && m_model->group(other, heading) == title && isBest(other))
      return true;
  return false;
}

bool LibraryOrder::lessThan(const QModelIndex& left, const QModelIndex& right) const {
  const int leftRank = m_model->groupRank(left.row(), m_grouping),
            rightRank = m_model->groupRank(right.row(), m_grouping);
  if (leftRank != rightRank) return leftRank < rightRank;
  const bool leftHeading = m_model->headingOf(left.row()) != LibraryGrouping::none;
  const bool rightHeading = m_model->headingOf(right.row()) != LibraryGrouping::none;
  if (leftHeading != rightHeading) return leftHeading;
  return QSortFilterProxyModel::lessThan(left, right);
}

namespace {
QString sentenceCase(const QString& text) { return text.left(1).toUpper() + text.mid(1); }

/// A button with the accent colour while it is pressed: the style's own look is hard to see on a dark ground.
class Chip final : public QToolButton {
 public:
  Chip() {
    setCheckable(true);
    connect(this, &QToolButton::toggled, this, &Chip::colour);
  }

 protected:
  /// A new theme sets the palette of each widget, and its style sheet takes it away again.
  void changeEvent(QEvent* event) override {
    QToolButton::changeEvent(event);
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::StyleChange) colour();
  }

 private:
  void colour() {
    if (std::exchange(m_colouring, true)) return;
    QPalette palette;
    if (isChecked()) {
      palette.setColor(QPalette::Button, palette.color(QPalette::Highlight));
      palette.setColor(QPalette::ButtonText, palette.color(QPalette::HighlightedText));
    }
    setPalette(palette);
    m_colouring = false;
  }

  bool m_colouring = false;
};
}  // namespace

LibraryChips::LibraryChips(const LibraryModel& model, QWidget* parent) : QWidget(parent), m_model(model) {
  auto* layout = new FlowLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(3);
  connect(&model, &QAbstractItemModel::modelReset, this, &LibraryChips::rebuild);
  connect(&model, &LibraryModel::notesChanged, this, &LibraryChips::followTags);
  connect(&model, &LibraryModel::notesReplaced, this, &LibraryChips::followTags);
  rebuild();
}

/// Chips that are pressed stay pressed if the library still has their kind.
void LibraryChips::rebuild() {
  for (QToolButton* chip : m_chips) delete chip;
  m_chips.clear();
  QStringList badges, kinds;
  QHash<QString, QString> meanings;
  for (int row = 0; row < m_model.rowCount(); ++row) {
    if (m_model.headingOf(row) != LibraryGrouping::none) continue;
    const QModelIndex index = m_model.index(row);
    badges << index.data(LibraryModel::BadgeRole).toString();
    meanings[badges.back()] = index.data(LibraryModel::BadgeMeaningRole).toString();
    kinds << m_model.group(row, LibraryGrouping::kind);
  }
  kinds.sort(Qt::CaseInsensitive);
  for (QStringList* list : {&badges, &kinds}) {
    list->removeAll(QString());
    list->removeDuplicates();
  }
  // The user's own badges come last: chips do not shift when the first document is saved.
  std::ranges::stable_partition(badges, [&](const QString& badge) { return !meanings[badge].isEmpty(); });
  m_tags = m_model.tags();
  const auto keep = [](QStringList& wanted, const QStringList& present) {
    wanted.removeIf([&](const QString& text) { return !present.contains(text); });
  };
  keep(m_filter.badges, badges);
  keep(m_filter.kinds, kinds);
  keep(m_filter.tags, m_tags);
  addChip(tr("Favourites"), tr("Shows only favourites"), m_filter.favourites);
  addChip(tr("Recent"), tr("Shows only materials opened in the last week"), m_filter.recent);
  for (const QString& badge : badges) {
    const QString toolTip = tr("Shows only materials with the badge \"%1\"").arg(badge);
    addMember(badge, (toolTip + '\n' + meanings[badge]).trimmed(), m_filter.badges)->setText(sentenceCase(badge));
  }
  for (const QString& kind : kinds)
    addMember(kind, tr("Shows only materials of the kind \"%1\"").arg(kind), m_filter.kinds);
  for (const QString& tag : m_tags)
    addMember(tag, tr("Shows only materials with the tag \"%1\"").arg(tag), m_filter.tags);
  Q_EMIT filterChanged();
}

void LibraryChips::followTags() {
  if (m_model.tags() != m_tags) rebuild();
}

QToolButton* LibraryChips::addButton(const QString& text, const QString& toolTip) {
  auto* chip = new Chip;
  chip->setText(menuText(text));
  chip->setToolTip(toolTip);
  chip->setFocusPolicy(Qt::StrongFocus);
  layout()->addWidget(chip);
  m_chips.push_back(chip);
  return chip;
}

void LibraryChips::addChip(const QString& text, const QString& toolTip, bool& wanted) {
  QToolButton* chip = addButton(text, toolTip);
  chip->setChecked(wanted);
  connect(chip, &QToolButton::toggled, this, [this, &wanted](bool on) {
    wanted = on;
    Q_EMIT filterChanged();
  });
}

QToolButton* LibraryChips::addMember(const QString& text, const QString& toolTip, QStringList& list) {
  QToolButton* chip = addButton(text, toolTip);
  chip->setChecked(list.contains(text));
  connect(chip, &QToolButton::toggled, this, [this, &list, text](bool on) {
    list.removeAll(text);
    if (on) list << text;
    Q_EMIT filterChanged();
  });
  return chip;
}

void LibraryChips::clear() {
  for (QToolButton* chip : m_chips) chip->setChecked(false);
}

QToolButton* LibraryChips::chip(const QString& text) const {
  const auto found = std::ranges::find_if(
      m_chips, [&](const QToolButton* one) { return one->text().compare(menuText(text), Qt::CaseInsensitive) == 0; });
  return found == m_chips.end() ? nullptr : *found;
}

}  // namespace gonio::widgets

#include "moc_library_chips.cpp"

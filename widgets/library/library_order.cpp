// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_order.h"

#include <QRegularExpression>
#include <algorithm>

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
  const QStringList own = wordsOf(QStringList{index.data().toString(), kind, tags.join(' ')}.join(' '));
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

bool LibraryOrder::filterAcceptsRow(int row, const QModelIndex&) const {
  const LibraryGrouping heading = m_model->headingOf(row);
  if (heading == LibraryGrouping::none) return matches(row);
  if (heading != m_grouping) return false;
  const QString title = m_model->group(row, heading);
  for (int other = 0; other < m_model->rowCount(); ++other)
    if (m_model->headingOf(other) == LibraryGrouping::none && m_model->group(other, heading) == title && matches(other))
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

}  // namespace gonio::widgets

#include "moc_library_order.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/library/library_model.h"

#include <QImage>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "core/math/colour.h"
#include "core/metrics/brdf_metric.h"
#include "core/rendering/tone_map.h"
#include "widgets/inputs/menu_text.h"
#include "widgets/inputs/plain_text_style.h"
#include "widgets/library/material_drag.h"

namespace gonio::widgets {

namespace {

constexpr double deltaEOfAnOctave = 10, minRoughness = 0.005;

const std::array<double, 256>& linearOfByte() {
  static const std::array<double, 256> table = [] {
    std::array<double, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = fromSrgb(double(i) / 255);
    return values;
  }();
  return table;
}

}  // namespace

Rgb meanLab(const QImage& picture) {
  const QImage pixels = picture.convertToFormat(QImage::Format_RGBA8888);
  const std::array<double, 256>& linear = linearOfByte();
  Rgb sum(0);
  double count = 0;
  for (int y = 0; y < pixels.height(); ++y) {
    const uchar* row = pixels.constScanLine(y);
    for (int x = 0; x < pixels.width(); ++x, row += 4)
      if (row[3] == 255) {
        sum += Rgb(linear[row[0]], linear[row[1]], linear[row[2]]);
        ++count;
      }
  }
  // A white pixel is as bright as the perfect diffuser.
  return metrics::labOf(sum / (std::max(1.0, count) * pi));
}

double dissimilarity(const Rgb& lab, double roughness, const Rgb& otherLab, double otherRoughness) {
  const double octaves = std::log2(std::max(roughness, minRoughness) / std::max(otherRoughness, minRoughness));
  return std::hypot(glm::distance(lab, otherLab), deltaEOfAnOctave * octaves);
}

QStringList tagsOf(const QString& text) {
  QStringList tags;
  for (const QString& part : text.split(',')) tags << part.simplified();
  tags.removeAll(QString());
  tags.removeDuplicates();
  return tags;
}

void LibraryModel::beginListing() {
  beginResetModel();
  m_entries.clear();
  m_headings.clear();
  m_qualities.clear();
  m_listing = true;
  endResetModel();
}

void LibraryModel::setItems(std::vector<LibraryItem> items) {
  beginResetModel();
  m_listing = false;
  std::map<QString, Entry> before;
  for (Entry& entry : m_entries) before.emplace(entry.item.id, std::move(entry));
  m_entries.clear();
  m_headings.clear();
  m_qualities.clear();
  QStringList sources, kinds;
  for (LibraryItem& item : items) {
    if (!sources.contains(item.source)) sources << item.source;
    if (!kinds.contains(item.kind)) kinds << item.kind;
    if (!item.material.isEmpty()) m_qualities[item.material].push_back(int(m_entries.size()));
    const auto known = before.find(item.id);
    Entry entry =
        known != before.end() && known->second.item.version == item.version ? std::move(known->second) : Entry{};
    entry.item = std::move(item);
    m_entries.push_back(std::move(entry));
  }
  kinds.sort(Qt::CaseInsensitive);
  addHeadings(LibraryGrouping::source, sources);
  addHeadings(LibraryGrouping::kind, kinds);
  endResetModel();
}

void LibraryModel::addHeadings(LibraryGrouping grouping, const QStringList& titles) {
  for (const QString& title : titles)
    if (!title.isEmpty()) m_headings.push_back({title, grouping});
}

const LibraryModel::Heading* LibraryModel::heading(int row) const {
  const std::size_t index = std::size_t(row) - m_entries.size();
  return std::size_t(row) < m_entries.size() ? nullptr : &m_headings[index];
}

LibraryGrouping LibraryModel::headingOf(int row) const {
  const Heading* found = heading(row);
  return found ? found->grouping : LibraryGrouping::none;
}

QString LibraryModel::group(int row, LibraryGrouping grouping) const {
  if (const Heading* found = heading(row)) return found->grouping == grouping ? found->title : QString();
  const LibraryItem& item = m_entries[std::size_t(row)].item;
  if (grouping == LibraryGrouping::none) return {};
  return grouping == LibraryGrouping::source ? item.source : item.kind;
}

int LibraryModel::groupRank(int row, LibraryGrouping grouping) const {
  const QString title = group(row, grouping);
  const auto found = std::find_if(m_headings.begin(), m_headings.end(),
                                  [&](const Heading& one) { return one.grouping == grouping && one.title == title; });
  return int(found - m_headings.begin());
}

std::vector<int> LibraryModel::qualities(int row) const {
  const QString material = heading(row) ? QString() : m_entries[std::size_t(row)].item.material;
  return material.isEmpty() ? std::vector{row} : m_qualities.value(material);
}

QStringList LibraryModel::qualitiesOf(const QString& id) const {
  QStringList ids;
  if (const int row = find(id); row >= 0)
    for (const int other : qualities(row)) ids << m_entries[std::size_t(other)].item.id;
  return ids;
}

QString LibraryModel::badge(const QString& id) const {
  const int row = find(id);
  return row < 0 ? QString() : m_entries[std::size_t(row)].item.badge;
}

int LibraryModel::find(const QString& id) const {
  const auto found = std::find_if(m_entries.begin(), m_entries.end(), [&](const Entry& e) { return e.item.id == id; });
  return found == m_entries.end() ? -1 : int(found - m_entries.begin());
}

void LibraryModel::setThumbnail(const QString& id, const LibraryThumbnail& thumbnail) {
  const int row = find(id);
  if (row < 0) return;
  Entry& entry = m_entries[std::size_t(row)];
  entry.thumbnail = thumbnail;
  entry.lab = meanLab(thumbnail.image);
  entry.pixmap = QPixmap::fromImage(thumbnail.image);
  entry.look = lookWords(thumbnail, entry.lab);
  Q_EMIT dataChanged(index(row), index(row));
}

void LibraryModel::setFailure(const QString& id, const QString& reason, const QString& badge) {
  const int row = find(id);
  if (row < 0) return;
  m_entries[std::size_t(row)].failure = reason;
  m_entries[std::size_t(row)].failureBadge = badge;
  Q_EMIT dataChanged(index(row), index(row));
}

void LibraryModel::setReference(const std::optional<LibraryThumbnail>& thumbnail) {
  m_reference.reset();
  if (thumbnail) m_reference = Reference{meanLab(thumbnail->image), thumbnail->roughness};
  if (!m_entries.empty()) Q_EMIT dataChanged(index(0), index(int(m_entries.size()) - 1), {DissimilarityRole});
}

const LibraryThumbnail* LibraryModel::thumbnail(const QString& id) const {
  const int row = find(id);
  return row < 0 || !m_entries[std::size_t(row)].thumbnail ? nullptr : &*m_entries[std::size_t(row)].thumbnail;
}

void LibraryModel::setNotes(LibraryNotes notes) {
  m_notes = std::move(notes);
  if (!m_entries.empty()) Q_EMIT dataChanged(index(0), index(int(m_entries.size()) - 1));
  Q_EMIT notesReplaced();
}

void LibraryModel::setNote(const QString& id, const LibraryNote& note) {
  changeNotes({id}, [&](LibraryNote& changed) { changed = note; });
}

void LibraryModel::changeNotes(const QStringList& ids, const std::function<void(LibraryNote&)>& change) {
  LibraryNotes changed;
  for (const QString& id : ids) {
    LibraryNote note = m_notes.value(id);
    change(note);
    if (m_notes.value(id) == note) continue;
    note.isEmpty() ? void(m_notes.remove(id)) : void(m_notes.insert(id, note));
    changed[id] = note;
  }
  if (changed.isEmpty()) return;
  // One signal: the order of the materials may depend on their notes.
  const int only = changed.size() == 1 ? find(changed.keyBegin().operator*()) : 0;
  if (only >= 0 && !m_entries.empty())
    Q_EMIT dataChanged(index(only), index(changed.size() == 1 ? only : int(m_entries.size()) - 1));
  Q_EMIT notesChanged(changed);
}

QStringList LibraryModel::tags() const {
  QStringList tags;
  for (const Entry& entry : m_entries) tags << m_notes.value(entry.item.id).tags;
  tags.removeDuplicates();
  tags.sort(Qt::CaseInsensitive);
  return tags;
}

QString LibraryModel::toolTip(const Entry& entry) const {
  QStringList lines;
  if (const QString name = spacedName(entry.item.name); !spacedName(entry.item.toolTip).contains(name))
    lines << QStringLiteral("<b>%1</b>").arg(name.toHtmlEscaped());
  lines << entry.item.toolTip.toHtmlEscaped();
  const LibraryNote note = m_notes.value(entry.item.id);
  if (note.rating > 0) lines << tr("Rating: %1 of %2").arg(note.rating).arg(LibraryNote::maxRating);
  if (!note.tags.isEmpty()) lines << tr("Tags: %1").arg(note.tags.join(QStringLiteral(", ")).toHtmlEscaped());
  if (!entry.failure.isEmpty()) lines << entry.failure.toHtmlEscaped();
  return lines.join(QStringLiteral("<br>"));
}

QStringList LibraryModel::pending() const {
  QStringList ids;
  for (const Entry& entry : m_entries)
    if (!entry.thumbnail && entry.failure.isEmpty()) ids << entry.item.id;
  return ids;
}

int LibraryModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : int(m_entries.size() + m_headings.size());
}

Qt::ItemFlags LibraryModel::flags(const QModelIndex& index) const {
  if (index.isValid() && heading(index.row())) return Qt::NoItemFlags;
  return QAbstractListModel::flags(index) | Qt::ItemIsDragEnabled;
}

QMimeData* LibraryModel::mimeData(const QModelIndexList& indexes) const {
  return indexes.isEmpty() ? nullptr : toDrag(indexes.front().data(IdRole).toString());
}

QString lookWords(const LibraryThumbnail& thumbnail, const Rgb& lab) {
  constexpr double smallestChroma = 12;  // below it, a metal with a tint is called grey
  const bool isGrey = thumbnail.hue < 0 || std::hypot(lab.y, lab.z) < smallestChroma;
  struct Range {
    double end;
    const char* words;
  };
  // Hues in degrees; L* in percent; widths of highlights as GGX alpha.
  constexpr Range
      hues[] = {{15, "red"},   {42, "orange brown"},   {70, "yellow gold"},   {165, "green"}, {200, "cyan turquoise"},
                {255, "blue"}, {290, "purple violet"}, {345, "pink magenta"}, {360, "red"}},
      lightnesses[] = {{22, "dark black"}, {75, "grey silver"}, {101, "light white"}},
      widths[] = {
          {0.03, "mirror polished shiny glossy"}, {0.12, "shiny glossy"}, {0.3, "satin"}, {2, "matt matte rough"}};
  const auto wordsAt = [](double value, std::span<const Range> ranges) {
    const auto found = std::ranges::find_if(ranges, [&](const Range& range) { return value < range.end; });
    return QString::fromLatin1(found == ranges.end() ? "" : found->words);
  };
  QStringList words{wordsAt(thumbnail.roughness, widths)};
  words << (isGrey ? wordsAt(lab.x, lightnesses) : wordsAt(thumbnail.hue, hues));
  if (!isGrey && lab.x < lightnesses[0].end) words << QStringLiteral("dark");
  return words.join(' ');
}

namespace {

/// Other words for the kinds of the bundled library.
QString otherNames(const QString& kind) {
  const std::pair<const char*, const char*> names[] = {
      {"paint", "carpaint lacquer coating"}, {"metal", "metallic"},  {"film", "vinyl foil wrap"},
      {"fabric", "cloth textile"},           {"plastic", "polymer"}, {"ceramic", "tile porcelain"}};
  for (const auto& [name, others] : names)
    if (kind.compare(QLatin1String(name), Qt::CaseInsensitive) == 0) return QString::fromLatin1(others);
  return {};
}

}  // namespace

QVariant LibraryModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  if (const Heading* found = heading(index.row())) {
    if (role == Qt::DisplayRole) return found->title;
    return role == HeadingRole ? QVariant(true) : QVariant();
  }
  const Entry& entry = m_entries[std::size_t(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return spacedName(entry.item.name);
    case Qt::DecorationRole:
      return entry.pixmap.isNull() ? QVariant() : entry.pixmap;
    case richToolTipRole:
      return toolTip(entry);
    case Qt::AccessibleDescriptionRole:
      return entry.item.toolTip;
    case IdRole:
      return entry.item.id;
    case HueRole:
      return entry.thumbnail ? entry.thumbnail->hue : 1e9;
    case LightnessRole:
      return entry.thumbnail ? -entry.lab.x : 1e9;
    case DissimilarityRole:
      return entry.thumbnail && m_reference
                 ? dissimilarity(entry.lab, entry.thumbnail->roughness, m_reference->lab, m_reference->roughness)
                 : 1e9;
    case RoughnessRole:
      return entry.thumbnail ? entry.thumbnail->roughness : 1e9;
    case FailureRole:
      return entry.failure;
    case FailureBadgeRole:
      return entry.failureBadge;
    case FavouriteRole:
      return m_notes.value(entry.item.id).favourite;
    case RatingRole:
      return m_notes.value(entry.item.id).rating;
    case RatingOrderRole:
      return -m_notes.value(entry.item.id).rating;
    case TagsRole:
      return m_notes.value(entry.item.id).tags;
    case OpenedRole:
      return m_notes.value(entry.item.id).opened;
    case OpenedOrderRole: {
      const QDateTime opened = m_notes.value(entry.item.id).opened;
      return opened.isNull() ? 1e18 : -double(opened.toMSecsSinceEpoch());
    }
    case LookRole:
      return QStringList{entry.look, otherNames(entry.item.kind)}.join(' ');
    case BadgeRole:
      return entry.item.badge;
    case BadgeMeaningRole:
      return entry.item.badgeMeaning;
    default:
      return {};
  }
}

}  // namespace gonio::widgets

#include "moc_library_model.cpp"

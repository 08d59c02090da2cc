// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/sheet_pictures.h"

#include <algorithm>
#include <utility>

#include "app/gonio/library/thumbnail.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

constexpr int sheetSide = 256, coarseSheetSamples = 32;
/// Leave noise of less than one of 255 steps of the display (docs/results/editor-tasks.md).
constexpr int fineSheetSamples = 256;

QImage mapImage(const std::vector<std::uint8_t>& rgba) {
  return QImage(rgba.data(), sheetSide, sheetSide, 4 * sheetSide, QImage::Format_RGBA8888).copy();
}

}  // namespace

LoadedMaterialPtr materialOf(const SheetSource& source, const TaskControl& control) {
  return source.material ? source.material : loadEdited(source.id.toStdString(), control);
}

SheetPictures::SheetPictures(BackgroundTasks& tasks, QObject* parent)
    : QObject(parent),
      m_tasks(tasks),
      m_renderKey(QStringLiteral("study sheet %1 pictures").arg(quintptr(this))),
      m_mapsKey(QStringLiteral("study sheet %1 maps").arg(quintptr(this))),
      m_samples(fineSheetSamples) {}

SheetPictures::~SheetPictures() {
  for (const QString& key : {m_renderKey, m_mapsKey}) m_tasks.drop(key);
}

void SheetPictures::setSources(std::vector<SheetSource> sources, int count) {
  std::vector<Picture> references;
  bool same = sources.size() == m_sources.size();
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto known = std::ranges::find_if(m_sources, [&](const SheetSource& one) {
      return one.material == sources[i].material && one.id == sources[i].id;
    });
    references.push_back(known == m_sources.end() ? Picture() : m_references[std::size_t(known - m_sources.begin())]);
    same = same && known != m_sources.end() && std::size_t(known - m_sources.begin()) == i;
  }
  if (!same) {
    for (const QString& key : {m_renderKey, m_mapsKey}) m_tasks.drop(key);
    m_renderer.reset();
    m_mapped.clear();
  }
  m_sources = std::move(sources);
  m_references = std::move(references);
  m_count = count;
  std::erase_if(m_pictures, [this](const auto& one) {
    return std::ranges::none_of(
        m_sources, [&](const SheetSource& source) { return std::ranges::count(source.entries, one.first) > 0; });
  });
  work();
}

void SheetPictures::setRendering(bool rendering) {
  m_rendering = rendering;
  if (!rendering) m_tasks.drop(m_renderKey);
  work();
}

void SheetPictures::setSamples(int samples) { m_samples = samples; }

std::vector<SheetEntry> SheetPictures::shown(std::size_t source) const {
  const std::vector<SheetEntry>& all = m_sources[source].entries;
  return {all.begin(), all.begin() + std::ptrdiff_t(std::min(all.size(), std::size_t(m_count)))};
}

SheetPictures::Picture SheetPictures::pictureOf(const SheetEntry& entry) const {
  const auto found = m_pictures.find(entry);
  return found == m_pictures.end() ? Picture() : found->second;
}

QPixmap SheetPictures::picture(const SheetEntry& entry) const { return pictureOf(entry).pixmap; }

QPixmap SheetPictures::map(const SheetEntry& entry) const { return pictureOf(entry).map; }

SheetEntry SheetPictures::missing(std::size_t source, Quality quality) const {
  for (const SheetEntry& entry : shown(source))
    if (entry && pictureOf(entry).quality < quality) return entry;
  return nullptr;
}

bool SheetPictures::hasAll(Quality quality) const {
  for (std::size_t i = 0; i < m_sources.size(); ++i)
    if (m_references[i].quality < quality || missing(i, quality)) return false;
  return true;
}

/// Pictures of one quality share their noise with their reference: maps of a mixture would show it.
bool SheetPictures::areAll(Quality quality) const {
  const Mapped all = mappable();
  return std::ranges::all_of(m_references, [&](const Picture& one) { return one.quality == quality; }) &&
         std::ranges::all_of(all, [&](const auto& one) { return one.second == quality; });
}

SheetPictures::Mapped SheetPictures::mappable() const {
  Mapped all;
  for (std::size_t i = 0; i < m_sources.size(); ++i)
    for (const SheetEntry& entry : shown(i))
      if (entry) all.insert({entry, pictureOf(entry).quality});
  return all;
}

bool SheetPictures::isComplete() const { return !mappable().empty() && hasAll(fine) && m_mapped == mappable(); }

rendering::RenderOptions SheetPictures::options(Quality quality) const {
  return {.width = sheetSide,
          .height = sheetSide,
          .samples = quality == fine ? m_samples : coarseSheetSamples,
          .density = {}};
}

std::function<void(const QString&)> SheetPictures::failure() {
  return [this](const QString& error) { Q_EMIT failed(tr("Cannot render the contact sheet"), error); };
}

/// Starts the next missing picture, all in coarse quality before the first in fine quality, and the maps of each.
void SheetPictures::work() {
  Q_EMIT changed();
  if (!m_rendering || mappable().empty() || m_tasks.isRunning(m_renderKey)) return;
  for (const Quality quality : {coarse, fine}) {
    for (std::size_t i = 0; i < m_sources.size(); ++i)
      if (m_references[i].quality < quality || missing(i, quality)) return workOn(i, quality);
    if (areAll(quality) && m_mapped != mappable() && !m_tasks.isRunning(m_mapsKey)) makeMaps();
  }
}

void SheetPictures::workOn(std::size_t source, Quality quality) {
  if (!m_renderer || m_renderer->source != source || m_renderer->quality != quality) return prepare(source, quality);
  if (const SheetEntry entry = missing(source, quality)) render(entry);
}

void SheetPictures::prepare(std::size_t source, Quality quality) {
  struct Prepared {
    std::shared_ptr<const rendering::RenderedComparison> comparison;
    QString kind;
  };
  m_tasks.run<Prepared>(
      {tr("Rendering %1").arg(widgets::spacedName(m_sources[source].name)), m_renderKey},
      [one = m_sources[source], options = options(quality)](const TaskControl& control) {
        const LoadedMaterialPtr material = materialOf(one, control.between(0, 0.3));
        return Prepared{std::make_shared<const rendering::RenderedComparison>(*material->material.brdf, options,
                                                                              control.between(0.3, 1)),
                        sourceKind(*material)};
      },
      [this, source, quality](const Prepared& prepared) {
        m_renderer = {source, quality, prepared.comparison};
        Picture& reference = m_references[source];
        if (reference.quality < quality) {
          const std::shared_ptr<const Image> image(prepared.comparison, &prepared.comparison->reference());
          reference = {quality, image, QPixmap::fromImage(displayedImage(*image)), {}, prepared.kind};
        }
        work();
      },
      failure());
}

void SheetPictures::render(const SheetEntry& entry) {
  m_tasks.run<std::shared_ptr<const Image>>(
      {tr("Rendering %1").arg(QString::fromStdString(entry->record.representation.shortLabel())), m_renderKey},
      [comparison = m_renderer->comparison, brdf = entry->brdf](const TaskControl& control) {
        return std::make_shared<const Image>(comparison->render(*brdf, control).image);
      },
      [this, entry, quality = m_renderer->quality](const std::shared_ptr<const Image>& image) {
        Picture& picture = m_pictures[entry];
        picture = {quality, image, QPixmap::fromImage(displayedImage(*image)), picture.map, {}};
        work();
      },
      failure());
}

void SheetPictures::makeMaps() {
  struct Row {
    std::shared_ptr<const Image> reference;
    std::vector<std::pair<SheetEntry, std::shared_ptr<const Image>>> pictures;
  };
  struct Made {
    std::vector<std::pair<SheetEntry, QImage>> maps;
    double range = 0;
  };
  std::vector<Row> rows;
  for (std::size_t i = 0; i < m_sources.size(); ++i) {
    Row row{m_references[i].image, {}};
    for (const SheetEntry& entry : shown(i))
      if (entry) row.pictures.emplace_back(entry, pictureOf(entry).image);
    rows.push_back(std::move(row));
  }
  m_tasks.run<Made>(
      {.title = tr("Comparing the images"), .key = m_mapsKey, .live = true},
      [rows](const TaskControl& control) {
        Made made;
        for (const Row& row : rows) {
          control.throwIfStopped();
          std::vector<Image> pictures;
          for (const auto& [entry, picture] : row.pictures) pictures.push_back(*picture);
          made.range = std::max(made.range, rendering::errorRange(*row.reference, pictures));
        }
        for (const Row& row : rows)
          for (const auto& [entry, picture] : row.pictures) {
            control.throwIfStopped();
            made.maps.emplace_back(entry, mapImage(rendering::errorMap(*row.reference, *picture, made.range)));
          }
        return made;
      },
      [this, mapped = mappable()](const Made& made) {
        for (const auto& [entry, map] : made.maps)
          if (const auto found = m_pictures.find(entry); found != m_pictures.end())
            found->second.map = QPixmap::fromImage(map);
        m_range = made.range;
        m_mapped = mapped;
        work();
      });
}

}  // namespace gonio::app

#include "moc_sheet_pictures.cpp"

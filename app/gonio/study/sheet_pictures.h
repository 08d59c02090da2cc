// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QObject>
#include <QPixmap>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "app/gonio/document/background_task.h"
#include "app/gonio/document/loaded_material.h"
#include "core/rendering/render_picture.h"

namespace gonio::study {
struct MeasuredRepresentation;
}

namespace gonio::app {

using SheetEntry = std::shared_ptr<const study::MeasuredRepresentation>;

/// A material and its measured representations, in the order of the sheet.
struct SheetSource {
  QString name;
  LoadedMaterialPtr material = nullptr;  ///< null: read from `id` when it is needed
  QString id = {};                       ///< of a material of the library
  std::vector<SheetEntry> entries = {};  ///< null: not measured
};

/// The material of a source. Not for the GUI thread. @throws Error, Cancelled.
LoadedMaterialPtr materialOf(const SheetSource& source, const TaskControl& control);

/// The pictures of a contact sheet: of materials and their representations, rendered one after the other in the
/// background, first coarsely, then without visible noise, and error maps on a scale that is common to all of them.
/// Pictures of materials and entries that remain stay.
class SheetPictures : public QObject {
  Q_OBJECT

 public:
  explicit SheetPictures(BackgroundTasks& tasks, QObject* parent);
  ~SheetPictures() override;

  /// Sets what is shown, each with its first `count` entries.
  void setSources(std::vector<SheetSource> sources, int count);
  /// Whether it renders; while not, the finished pictures stay. Initially false.
  void setRendering(bool rendering);
  /// Sets the samples per pixel of the finished pictures.
  void setSamples(int samples);

  const std::vector<SheetSource>& sources() const { return m_sources; }
  /// The first entries of a source; null: not measured.
  std::vector<SheetEntry> shown(std::size_t source) const;
  /// Null until it is rendered.
  QPixmap reference(std::size_t source) const { return m_references[source].pixmap; }
  QPixmap picture(const SheetEntry& entry) const;
  QPixmap map(const SheetEntry& entry) const;
  /// Kind of a material, as sourceKind(); empty until its picture is rendered.
  QString kind(std::size_t source) const { return m_references[source].kind; }
  /// The absolute luminance difference of the last colour of the maps; 0: no maps yet.
  double range() const { return m_range; }
  /// Whether all pictures and maps that are shown are finished.
  bool isComplete() const;

 Q_SIGNALS:
  void changed();
  void failed(const QString& title, const QString& text);

 private:
  enum Quality { none, coarse, fine };
  struct Picture {
    Quality quality = none;
    std::shared_ptr<const Image> image = nullptr;
    QPixmap pixmap = {}, map = {};
    QString kind = {};  ///< of a reference
  };
  /// Renders the pictures of one source in one quality.
  struct Renderer {
    std::size_t source;
    Quality quality;
    std::shared_ptr<const rendering::RenderedComparison> comparison;
  };
  using Mapped = std::set<std::pair<SheetEntry, Quality>>;

  Picture pictureOf(const SheetEntry& entry) const;
  /// Null: none is missing.
  SheetEntry missing(std::size_t source, Quality quality) const;
  bool hasAll(Quality quality) const;
  bool areAll(Quality quality) const;
  Mapped mappable() const;
  rendering::RenderOptions options(Quality quality) const;
  void work();
  void workOn(std::size_t source, Quality quality);
  void prepare(std::size_t source, Quality quality);
  void render(const SheetEntry& entry);
  void makeMaps();
  std::function<void(const QString&)> failure();

  BackgroundTasks& m_tasks;
  const QString m_renderKey, m_mapsKey;
  std::vector<SheetSource> m_sources;
  std::vector<Picture> m_references;  ///< of m_sources
  int m_count = 0;
  std::map<SheetEntry, Picture> m_pictures;
  std::optional<Renderer> m_renderer;
  Mapped m_mapped;  ///< whose maps are on the common scale
  double m_range = 0;
  bool m_rendering = false;
  int m_samples;
};

}  // namespace gonio::app

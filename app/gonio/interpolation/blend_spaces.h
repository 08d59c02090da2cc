// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QImage>
#include <QObject>
#include <QPointF>
#include <array>
#include <optional>

#include "app/gonio/document/background_task.h"
#include "core/models/registry.h"
#include "core/study/accuracy_study.h"
#include "widgets/interpolation/prepared_blend.h"

namespace gonio::app {

/// Size and samples of the small spheres.
struct StripPictures {
  int side = 112, samples = 16;
};

/// What a space costs: at equal weights, and how far its ends are from the materials.
struct BlendCost {
  study::UseCost middle;
  double lowestEndSnr = 0;  ///< rendered SNR of a weight of 1 against the material, the lowest of all, dB
};

/// Prepares the blends of materials in all interpolation spaces, one space after the other in the background, and
/// renders rows of small spheres for the comparison of the spaces.
class BlendSpaces : public QObject {
  Q_OBJECT

 public:
  using Space = interpolation::InterpolationSpace;
  static constexpr int pictureCount = 7;  ///< t = 0, 1/6, .. 1 on the path of widgets::pathPosition()
  enum class State { waiting, running, ready, failed, cancelled };

  explicit BlendSpaces(BackgroundTasks& tasks, QObject* parent = nullptr, const StripPictures& pictures = {});

  /// The available spaces, in the order of display.
  const std::vector<Space>& spaces() const { return m_spaces; }

  /// Sets the materials; empty: none. Prepared blends are reused if the materials are those of the last non-empty set,
  /// in any order. Otherwise all blends are prepared again on demand, in about a second per material: nothing is reused
  /// for a material that stays, because the nodes and dictionaries of a blend depend on all materials.
  void setMaterials(std::vector<interpolation::InterpolationMaterial> materials);
  /// Sets the model of the spaces `parameters` and `differential`, which are prepared again.
  void setModel(const models::Model& model);
  const models::Model& model() const { return *m_model; }
  /// InterpolationOptions::preserveDetail; the spaces that lose detail are prepared again.
  void setPreservesDetail(bool preserves);
  bool preservesDetail() const { return m_preservesDetail; }
  static bool usesModel(Space space) { return space == Space::parameters || space == Space::differential; }
  bool hasMaterials() const { return m_complete; }
  /// For each slot, the index of its material in PreparedBlend::materials, which has the order in which the materials
  /// were first set.
  const std::vector<std::size_t>& order() const { return m_order; }
  /// Weights of the slots in the order of PreparedBlend::materials.
  std::vector<double> ordered(const std::vector<double>& weights) const;
  /// Starts or resumes the work with this space, even if it was cancelled or failed.
  void want(Space first);
  /// Stops the work until want().
  void pause();

  State state(Space space) const { return entry(space).state; }
  QString failure(Space space) const { return entry(space).failure; }
  /// Null until it is ready, which is before its pictures are.
  widgets::PreparedBlendPtr prepared(Space space) const { return entry(space).prepared; }
  /// Empty until they are rendered.
  const std::vector<QImage>& pictures(Space space) const { return entry(space).pictures; }
  /// Empty until the pictures are rendered.
  const std::optional<BlendCost>& cost(Space space) const { return entry(space).cost; }
  /// Whether no work is running or waiting.
  bool isSettled() const;

 Q_SIGNALS:
  /// The state or the results of a space changed.
  void changed(gonio::interpolation::InterpolationSpace space);

 private:
  struct Entry {
    State state = State::waiting;
    widgets::PreparedBlendPtr prepared;
    std::vector<QImage> pictures;
    std::optional<BlendCost> cost;
    QString failure;
  };
  const Entry& entry(Space space) const {
    static const Entry none;
    return m_complete ? m_entries[std::size_t(space)] : none;
  }
  Entry& entry(Space space) { return m_entries[std::size_t(space)]; }
  void turnPictures();
  /// Forgets what was prepared of the spaces for which `depends(space)` is true, and prepares it again if wanted.
  template <class Depends>
  void forget(const Depends& depends);
  void next();
  void prepare(Space space);
  void draw(Space space);
  void fail(Space space, const QString& error);
  void cancelAll();

  BackgroundTasks& m_tasks;
  StripPictures m_stripPictures;
  std::vector<Space> m_spaces;
  std::vector<interpolation::InterpolationMaterial> m_materials;  ///< in the order of PreparedBlend::materials
  std::vector<std::size_t> m_order;
  bool m_complete = false;
  const models::Model* m_model = &models::ggx();
  bool m_preservesDetail = true;
  std::array<Entry, interpolation::interpolationSpaceNames.size()> m_entries;
  Space m_first = Space::linear;
  bool m_wanted = false;
};

}  // namespace gonio::app

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/interpolation/blend_spaces.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "app/gonio/library/thumbnail.h"
#include "widgets/interpolation/blend_position.h"

namespace gonio::app {

namespace {

const QString blendKey = QStringLiteral("blend-spaces");

bool sameMaterial(const interpolation::InterpolationMaterial& a, const interpolation::InterpolationMaterial& b) {
  return a.table == b.table && a.factors == b.factors && a.code == b.code && a.base == b.base;
}

/// Where each of `materials` stands in `known`; empty where these are other ones.
std::vector<std::size_t> orderIn(const std::vector<interpolation::InterpolationMaterial>& known,
                                 const std::vector<interpolation::InterpolationMaterial>& materials) {
  if (known.size() != materials.size()) return {};
  std::vector<std::size_t> order;
  for (const interpolation::InterpolationMaterial& material : materials)
    for (std::size_t i = 0; i < known.size(); ++i)
      if (sameMaterial(known[i], material) && std::find(order.begin(), order.end(), i) == order.end()) {
        order.push_back(i);
        break;
      }
  return order.size() == materials.size() ? order : std::vector<std::size_t>();
}

std::vector<double> inOrder(const std::vector<std::size_t>& order, const std::vector<double>& weights) {
  std::vector<double> result(weights.size());
  for (std::size_t slot = 0; slot < weights.size(); ++slot) result[order[slot]] = weights[slot];
  return result;
}

std::vector<QImage> drawStrip(const widgets::PreparedBlend& blend, const std::vector<std::size_t>& order,
                              const StripPictures& strip, const TaskControl& control) {
  std::vector<QImage> pictures;
  const int materials = int(blend.materials.size());
  for (int i = 0; i < BlendSpaces::pictureCount; ++i) {
    const double t = i / (BlendSpaces::pictureCount - 1.0);
    const auto weights = inOrder(order, widgets::weightsAt(materials, widgets::pathPosition(materials, t)));
    pictures.push_back(
        spherePicture(*blend.interpolation->brdf(weights), strip.side, strip.samples, {control.stop, {}}));
    control.report((i + 1.0) / BlendSpaces::pictureCount);
  }
  return pictures;
}

}  // namespace

BlendSpaces::BlendSpaces(BackgroundTasks& tasks, QObject* parent, const StripPictures& pictures)
    : QObject(parent),
      m_tasks(tasks),
      m_stripPictures(pictures),
      m_spaces{Space::linear, Space::parameters, Space::differential, Space::factors, Space::dictionary} {}

void BlendSpaces::setMaterials(std::vector<interpolation::InterpolationMaterial> materials) {
  pause();
  m_complete = !materials.empty();
  if (const auto order = orderIn(m_materials, materials); m_complete && order.empty()) {
    m_materials = std::move(materials);
    m_entries = {};
    m_order.resize(m_materials.size());
    std::iota(m_order.begin(), m_order.end(), 0);
  } else if (m_complete && order != m_order) {
    m_order = order;
    turnPictures();
  }
  for (const Space space : m_spaces) Q_EMIT changed(space);
}

template <class Depends>
void BlendSpaces::forget(const Depends& depends) {
  const bool wanted = m_wanted;
  pause();
  for (const Space space : m_spaces) {
    if (!depends(space)) continue;
    entry(space) = {};
    Q_EMIT changed(space);
  }
  if (wanted) want(m_first);
}

void BlendSpaces::setModel(const models::Model& model) {
  if (&model == m_model) return;
  m_model = &model;
  forget(usesModel);
}

void BlendSpaces::setPreservesDetail(bool preserves) {
  if (preserves == m_preservesDetail) return;
  m_preservesDetail = preserves;
  forget(interpolation::losesDetail);
}

std::vector<double> BlendSpaces::ordered(const std::vector<double>& weights) const { return inOrder(m_order, weights); }

void BlendSpaces::turnPictures() {
  for (Entry& entry : m_entries) {
    // Of two materials it is the same way backward, of more another one.
    if (m_materials.size() == 2) {
      std::reverse(entry.pictures.begin(), entry.pictures.end());
    } else if (entry.state == State::ready) {
      entry.pictures.clear();
      entry.state = State::waiting;
    }
  }
}

void BlendSpaces::want(Space first) {
  m_first = first;
  if (!m_complete) return;
  const bool again = entry(first).state == State::failed || entry(first).state == State::cancelled;
  for (const Space space : m_spaces)
    if (entry(space).state == State::cancelled || (again && space == first)) entry(space).state = State::waiting;
  const bool idle = !m_wanted || !m_tasks.isRunning(blendKey);
  m_wanted = true;
  if (idle) next();
}

void BlendSpaces::pause() {
  m_wanted = false;
  m_tasks.drop(blendKey);
  for (const Space space : m_spaces)
    if (entry(space).state == State::running) entry(space).state = State::waiting;
}

bool BlendSpaces::isSettled() const {
  return !m_wanted || std::all_of(m_spaces.begin(), m_spaces.end(), [this](Space space) {
    return state(space) != State::waiting && state(space) != State::running;
  });
}

void BlendSpaces::next() {
  if (!m_wanted || !m_complete) return;
  std::vector<Space> order = m_spaces;
  std::stable_partition(order.begin(), order.end(), [this](Space space) { return space == m_first; });
  for (const Space space : order) {
    if (state(space) != State::waiting) continue;
    entry(space).state = State::running;
    Q_EMIT changed(space);
    return entry(space).prepared ? draw(space) : prepare(space);
  }
}

void BlendSpaces::prepare(Space space) {
  m_tasks.run<widgets::PreparedBlendPtr>(
      {tr("Preparing blend: %1").arg(widgets::spaceName(space)), blendKey},
      [space, materials = m_materials, model = m_model, detail = m_preservesDetail](const TaskControl& control) {
        return widgets::prepareBlend(space, materials, documents::blendOptions(model, detail), control);
      },
      [this, space](const widgets::PreparedBlendPtr& prepared) {
        entry(space).prepared = prepared;
        Q_EMIT changed(space);
        // Another space that is wanted under the hand goes before these pictures.
        entry(space).state = State::waiting;
        if (space != m_first && state(m_first) == State::waiting) return next();
        entry(space).state = State::running;
        draw(space);
      },
      [this, space](const QString& error) { fail(space, error); }, [this] { cancelAll(); });
}

namespace {

BlendCost costOf(const interpolation::Interpolation& blend, const TaskControl& control) {
  const std::size_t count = blend.ends().size();
  BlendCost cost{.lowestEndSnr = std::numeric_limits<double>::infinity()};
  for (std::size_t i = 0; i < count; ++i) {
    const auto material = blend.ends()[i].material();
    std::vector<double> weights(count, 0.0);
    weights[i] = 1;
    const auto end = blend.brdf(weights);
    if (end == material) continue;
    const rendering::RenderedComparison comparison(*material, rendering::smallComparisonPicture(), {control.stop, {}});
    cost.lowestEndSnr =
        std::min(cost.lowestEndSnr, comparison.signalToNoiseRatio(comparison.render(*end, {control.stop, {}})));
    control.report(double(i + 1) / double(count + 1));
  }
  cost.middle = study::measureUse(*blend.brdf(std::vector<double>(count, 1.0 / double(count))), {control.stop, {}});
  return cost;
}

}  // namespace

void BlendSpaces::draw(Space space) {
  struct Drawn {
    std::vector<QImage> pictures;
    BlendCost cost;
  };
  m_tasks.run<Drawn>(
      {tr("Rendering blend: %1").arg(widgets::spaceName(space)), blendKey},
      [prepared = entry(space).prepared, order = m_order, strip = m_stripPictures](const TaskControl& control) {
        constexpr double drawn = 0.6;
        return Drawn{drawStrip(*prepared, order, strip, control.between(0, drawn)),
                     costOf(*prepared->interpolation, control.between(drawn, 1))};
      },
      [this, space](const Drawn& drawn) {
        entry(space).pictures = drawn.pictures;
        entry(space).cost = drawn.cost;
        entry(space).state = State::ready;
        Q_EMIT changed(space);
        next();
      },
      [this, space](const QString& error) { fail(space, error); }, [this] { cancelAll(); });
}

void BlendSpaces::fail(Space space, const QString& error) {
  entry(space).failure = error;
  entry(space).state = State::failed;
  Q_EMIT changed(space);
  next();
}

void BlendSpaces::cancelAll() {
  m_wanted = false;
  for (const Space space : m_spaces) {
    State& state = entry(space).state;
    if (state == State::waiting || state == State::running) state = State::cancelled;
    Q_EMIT changed(space);
  }
}

}  // namespace gonio::app

#include "moc_blend_spaces.cpp"

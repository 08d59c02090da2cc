// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/lobe_stage.h"

#include <QVector2D>
#include <QVector4D>
#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "core/editing/lobe_change.h"
#include "widgets/preview/gl/model_uniforms.h"

namespace gonio::widgets {

namespace {

using editing::LobeEffect;
using editing::LobeWarp;

bool hasGrain(const models::Model& model) { return model.spec().find("rotation").has_value(); }

/// A part that the fit does not contain has no ratio to carry.
bool isNew(const LobeEffect& change) {
  return change.kind != LobeEffect::none && !change.wasNonzero && change.isNonzero;
}
bool carries(const LobeEffect& change) { return change.kind == LobeEffect::highlight && change.wasNonzero; }

/// The changes of an edit, and the different places that its highlights had.
struct Parts {
  std::vector<LobeEffect> changes;
  std::vector<LobeWarp> places;

  explicit Parts(const editing::DifferentialEdit& edit) : changes(editing::lobeEffects(edit)) {
    for (const LobeEffect& change : changes)
      if (carries(change) && std::ranges::find(places, change.warp) == places.end()) places.push_back(change.warp);
  }

  /// "(before[1] + before[3])" of the parts that are wanted.
  template <typename Wanted>
  QString sum(const char* values, const Wanted& wanted) const {
    QStringList terms;
    for (std::size_t k = 0; k < changes.size(); ++k)
      if (wanted(changes[k])) terms << QString("%1[%2]").arg(values).arg(k);
    return terms.isEmpty() ? QStringLiteral("vec3(0.0)") : '(' + terms.join(" + ") + ')';
  }
};

/// The function while it is put together.
struct LobeStage {
  QString previous, model, number;
  bool alongGrain;
  Parts parts;

  QString lobes(const char* directions, const char* parameters, const char* values) const {
    return QString("vec3 %1[%2]; lobes_%3(%4, %5%6, %1); ")
        .arg(values)
        .arg(parts.changes.size())
        .arg(model, directions, parameters, number);
  }

  QString begin(const QString& name) const {
    return QString(
               "vec3 %1(vec3 wi, vec3 wo, out bool valid) { vec3 value = %2(wi, wo, valid);"
               " if (!valid || wi.z <= 0.0 || wo.z <= 0.0) return value; ")
               .arg(name, previous) +
           lobes("wi, wo", "fitted", "before") + lobes("wi, wo", "edited", "after") +
           "vec3 model = " + parts.sum("before", std::mem_fn(&LobeEffect::wasNonzero)) + ';' +
           "vec3 ratio = fitRatio(value, model); vec3 change = " + parts.sum("after", isNew) + " - ratio * " +
           parts.sum("before", carries) + "; ";
  }

  QString bodies() const {
    QString result;
    for (std::size_t k = 0; k < parts.changes.size(); ++k)
      if (parts.changes[k].kind == LobeEffect::diffuse && parts.changes[k].wasNonzero)
        result += QString("change += diffuseChange(ratio, before[%1], after[%1], model); ").arg(k);
    return result;
  }

  /// Declares `carried`, the ratio that the lobes carry from a place.
  QString carriedFrom(std::size_t place) const {
    if (parts.places[place].isIdentity()) return "vec3 carried = ratio; ";
    const QString at = QString("%1[%2]").arg(number).arg(place);
    const QString warp = alongGrain ? QString("scaleHalfSlopesAlongGrain(movedIn, movedOut, scales%1, grains%1); ")
                                    : QString("scaleHalfSlopes(movedIn, movedOut, scales%1.xx); ");
    const bool inPlane = !alongGrain && previous == "measuredBrdf";
    const QString value = inPlane ? QStringLiteral("measuredInPlane(wi, wo, movedIn, movedOut, known)")
                                  : previous + "(movedIn, movedOut, known)";
    return "vec3 movedIn = wi, movedOut = wo; bool known; " + warp.arg(at) + "vec3 moved = " + value + "; " +
           lobes("movedIn, movedOut", "fitted", "there") + "vec3 carried = fitRatio(moved, " +
           parts.sum("there", std::mem_fn(&LobeEffect::wasNonzero)) + "); if (!known) carried = ratio; ";
  }

  QString gainedFrom(std::size_t place) const {
    const auto isThere = [&](const LobeEffect& c) {
      return carries(c) && c.isNonzero && c.warp == parts.places[place];
    };
    QString result = "change += carried * " +
                     parts.sum("after", [&](const LobeEffect& c) { return isThere(c) && !c.isRecoloured; }) + "; ";
    for (std::size_t k = 0; k < parts.changes.size(); ++k)
      if (isThere(parts.changes[k]) && parts.changes[k].isRecoloured)
        result += QString("change += after[%1] * recolouredRatio(carried, before[%1], after[%1]); ").arg(k);
    return result;
  }

  QString function(const QString& name) const {
    QString result = begin(name) + bodies();
    for (std::size_t place = 0; place < parts.places.size(); ++place)
      result += "{ " + carriedFrom(place) + gainedFrom(place) + "} ";
    return ' ' + result + QString("return withChange(value, strength%1 * change); }").arg(number);
  }
};

}  // namespace

QString lobeUniforms(const editing::DifferentialEdit& edit, int number) {
  const std::size_t places = Parts(edit).places.size();
  return places == 0 ? QString()
                     : QString(" uniform vec2 scales%1[%2]; uniform vec4 grains%1[%2];").arg(number).arg(places);
}

QString lobeStage(const QString& name, const QString& previous, const editing::DifferentialEdit& edit, int number) {
  const LobeStage stage{previous, modelName(*edit.model), QString::number(number), hasGrain(*edit.model), Parts(edit)};
  return stage.function(name);
}

void setLobeUniforms(QOpenGLShaderProgram& program, const QString& number, const editing::DifferentialEdit& edit) {
  std::vector<QVector2D> scales;
  std::vector<QVector4D> grains;
  for (const LobeWarp& warp : Parts(edit).places) {
    scales.emplace_back(float(warp.scale.x), float(warp.scale.y));
    grains.emplace_back(float(std::cos(warp.edited)), float(std::sin(warp.edited)), float(std::cos(warp.fitted)),
                        float(std::sin(warp.fitted)));
  }
  if (scales.empty()) return;
  const auto location = [&](const char* name) { return program.uniformLocation(name + number); };
  program.setUniformValueArray(location("scales"), scales.data(), int(scales.size()));
  program.setUniformValueArray(location("grains"), grains.data(), int(grains.size()));
}

}  // namespace gonio::widgets

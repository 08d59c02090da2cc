// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/lobe_stage.h"

#include <QVector2D>
#include <QVector3D>
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
  std::vector<std::size_t> highlights;  ///< that are not black in the fit; empty if the edit does not keep the albedo

  explicit Parts(const editing::DifferentialEdit& edit) : changes(editing::lobeEffects(edit)) {
    for (const LobeEffect& change : changes)
      if (carries(change) && std::ranges::find(places, change.warp) == places.end()) places.push_back(change.warp);
    for (std::size_t k = 0; k < changes.size(); ++k)
      if (edit.keepsAlbedo && changes[k].wasNonzero && changes[k].width.x > 0) highlights.push_back(k);
  }

  bool keepsAlbedo() const { return !highlights.empty(); }
  /// Whether the factor of the albedo applies to a lobe.
  bool isScaled(const LobeEffect& change) const {
    return keepsAlbedo() && carries(change) && change.isNonzero && change.warp.scale != glm::dvec2(1);
  }
  bool scalesAny() const {
    return std::ranges::any_of(changes, [this](const LobeEffect& change) { return isScaled(change); });
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

  QString ratioFunction() const { return parts.keepsAlbedo() ? "closeFitRatio" : "fitRatio"; }

  /// Declares `peak`, the excess e of LobeChange, and `share` of each highlight, for the lobes `values`. @param suffix
  /// of these names.
  QString peak(const QString& suffix, const QString& directions, const QString& measured, const QString& values,
               const QString& total, const QString& ratio) const {
    if (!parts.keepsAlbedo()) return {};
    QStringList sums, centres, powers;
    QString result;
    for (std::size_t i = 0; i < parts.highlights.size(); ++i) {
      const std::size_t k = parts.highlights[i];
      const QString luminance = QString("luminance%1_%2").arg(suffix).arg(k);
      result += QString("float %1 = luminanceOf(%2[%3]); ").arg(luminance, values).arg(k);
      sums << QString("%1[%2]").arg(values).arg(k);
      centres << QString("%1 * centreOf(halfway%2, widths%3[%4])").arg(luminance, suffix, number).arg(i);
      powers << QString("%1 * inverse%2 * fourthPower(%1 * inverse%2)").arg(luminance, suffix);
    }
    const bool isOne = parts.highlights.size() == 1;
    result += QString(
                  "vec3 halfway%1 = %2; halfway%1 /= max(length(halfway%1), 1e-6); vec3 sum%1 = %3; "
                  "float inverse%1 = 1.0 / max(luminanceOf(sum%1), 1e-30); "
                  "vec3 excess%1 = excessOf(max(vec3(0.0), 1.0 - sum%1 / max(%4, vec3(1e-30)))); "
                  "vec3 peak%1 = peakOf(%5, luminanceOf(%4)) * (%6) * inverse%1 * (%7 - 1.0); ")
                  .arg(suffix, directions, sums.join(" + "), total, measured, centres.join(" + "), ratio);
    if (!isOne) result += QString("excess%1 /= max(%2, 1e-30); ").arg(suffix, powers.join(" + "));
    for (const std::size_t k : parts.highlights)
      result += QString("vec3 share%1_%2 = excess%1%3; ")
                    .arg(suffix)
                    .arg(k)
                    .arg(isOne ? QString() : QString(" * fourthPower(luminance%1_%2 * inverse%1)").arg(suffix).arg(k));
    return result;
  }

  QString begin(const QString& name) const {
    QString result = QString(
                         "vec3 %1(vec3 wi, vec3 wo, out bool valid) { vec3 value = %2(wi, wo, valid);"
                         " if (!valid || wi.z <= 0.0 || wo.z <= 0.0) return value; ")
                         .arg(name, previous) +
                     lobes("wi, wo", "fitted", "before") + lobes("wi, wo", "edited", "after") +
                     "vec3 model = " + parts.sum("before", std::mem_fn(&LobeEffect::wasNonzero)) + ';' +
                     QString("vec3 ratio = %1(value, model); ").arg(ratioFunction()) +
                     peak("", "wi + wo", "value", "before", "model", "ratio") +
                     "vec3 change = " + parts.sum("after", isNew);
    if (!parts.keepsAlbedo()) return result + " - ratio * " + parts.sum("before", carries) + "; ";
    for (std::size_t k = 0; k < parts.changes.size(); ++k)
      if (carries(parts.changes[k])) result += QString(" - before[%1] * (ratio + (share_%1 - 1.0) * peak)").arg(k);
    result += "; ";
    if (parts.scalesAny())
      result += QString(
                    "float placeIn = albedoPlace(wi.z), placeOut = albedoPlace(wo.z); "
                    "vec3 scale = ALBEDO_SCALE(albedo%1, placeIn) * ALBEDO_SCALE(albedo%1, placeOut); ")
                    .arg(number);
    return result;
  }

  QString bodies() const {
    QString result;
    for (std::size_t k = 0; k < parts.changes.size(); ++k)
      if (parts.changes[k].kind == LobeEffect::diffuse && parts.changes[k].wasNonzero)
        result += QString("change += diffuseChange(ratio, before[%1], after[%1], model); ").arg(k);
    return result;
  }

  /// Declares `carried`, the ratio that the lobes carry from a place, with its peak.
  QString carriedFrom(std::size_t place) const {
    if (parts.places[place].isIdentity()) {
      QString result = "vec3 carried = ratio; ";
      if (!parts.keepsAlbedo()) return result;
      result += "float kept = 1.0; vec3 peakThere = peak; ";
      for (const std::size_t k : parts.highlights) result += QString("vec3 shareThere_%1 = share_%1; ").arg(k);
      return result;
    }
    const QString at = QString("%1[%2]").arg(number).arg(place);
    const QString warp = alongGrain ? QString("scaleHalfSlopesAlongGrain(movedIn, movedOut, scales%1, grains%1); ")
                                    : QString("scaleHalfSlopes(movedIn, movedOut, scales%1.xx); ");
    const bool inPlane = !alongGrain && previous == "measuredBrdf";
    const QString value = inPlane ? QStringLiteral("measuredInPlane(wi, wo, movedIn, movedOut, known)")
                                  : previous + "(movedIn, movedOut, known)";
    QString result = "vec3 movedIn = wi, movedOut = wo; bool known; " + warp.arg(at) + "vec3 moved = " + value + "; " +
                     lobes("movedIn, movedOut", "fitted", "there") +
                     "vec3 modelThere = " + parts.sum("there", std::mem_fn(&LobeEffect::wasNonzero)) +
                     QString("; vec3 carried = %1(moved, modelThere); ").arg(ratioFunction()) +
                     peak("There", "movedIn + movedOut", "moved", "there", "modelThere", "carried") +
                     "if (!known) carried = ratio; ";
    if (!parts.keepsAlbedo()) return result;
    result +=
        QString("float kept = min(1.0, scales%1.x * scales%1.y); kept *= kept; if (!known) peakThere = peak; ").arg(at);
    for (const std::size_t k : parts.highlights) result += QString("if (!known) shareThere_%1 = share_%1; ").arg(k);
    return result;
  }

  QString gainedFrom(std::size_t place) const {
    const auto isThere = [&](const LobeEffect& c) {
      return carries(c) && c.isNonzero && c.warp == parts.places[place];
    };
    QString result;
    if (!parts.keepsAlbedo())
      result = "change += carried * " +
               parts.sum("after", [&](const LobeEffect& c) { return isThere(c) && !c.isRecoloured; }) + "; ";
    for (std::size_t k = 0; k < parts.changes.size(); ++k) {
      const LobeEffect& change = parts.changes[k];
      if (!isThere(change) || !(parts.keepsAlbedo() || change.isRecoloured)) continue;
      QString ratio = "carried";
      if (parts.keepsAlbedo()) ratio = QString("(carried + (shareThere_%1 * kept - 1.0) * peakThere)").arg(k);
      if (change.isRecoloured) ratio = QString("recolouredRatio(%1, before[%2], after[%2])").arg(ratio).arg(k);
      result += QString("change += after[%1] * %2%3; ").arg(k).arg(ratio, parts.isScaled(change) ? " * scale" : "");
    }
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
  const Parts parts(edit);
  QString uniforms;
  if (!parts.places.empty())
    uniforms += QString(" uniform vec2 scales%1[%2]; uniform vec4 grains%1[%2];").arg(number).arg(parts.places.size());
  if (parts.keepsAlbedo()) uniforms += QString(" uniform vec4 widths%1[%2];").arg(number).arg(parts.highlights.size());
  // Not one of the flat inputs: it is indexed by the angle.
  if (parts.scalesAny()) uniforms += QString(" uniform vec3 albedo%1[ALBEDO_NODES];").arg(number);
  return uniforms;
}

QString lobeStage(const QString& name, const QString& previous, const editing::DifferentialEdit& edit, int number) {
  const LobeStage stage{previous, modelName(*edit.model), QString::number(number), hasGrain(*edit.model), Parts(edit)};
  return stage.function(name);
}

void setLobeUniforms(QOpenGLShaderProgram& program, const QString& number, const editing::DifferentialEdit& edit,
                     const editing::AlbedoScale& scale) {
  const Parts parts(edit);
  const auto location = [&](const char* name) { return program.uniformLocation(name + number); };
  std::vector<QVector2D> scales;
  std::vector<QVector4D> grains, widths;
  for (const LobeWarp& warp : parts.places) {
    scales.emplace_back(float(warp.scale.x), float(warp.scale.y));
    grains.emplace_back(float(std::cos(warp.edited)), float(std::sin(warp.edited)), float(std::cos(warp.fitted)),
                        float(std::sin(warp.fitted)));
  }
  for (const std::size_t k : parts.highlights) {
    const models::LobeWidth& width = parts.changes[k].width;
    constexpr double extent = editing::LobeChange::peakExtent;
    widths.emplace_back(float(1 / (extent * width.x)), float(1 / (extent * width.y)), float(std::cos(width.rotation)),
                        float(std::sin(width.rotation)));
  }
  if (!scales.empty()) {
    program.setUniformValueArray(location("scales"), scales.data(), int(scales.size()));
    program.setUniformValueArray(location("grains"), grains.data(), int(grains.size()));
  }
  if (!widths.empty()) program.setUniformValueArray(location("widths"), widths.data(), int(widths.size()));
  if (!parts.scalesAny()) return;
  std::vector<QVector3D> values;
  for (const Rgb& s : scale.values) values.emplace_back(float(s.x), float(s.y), float(s.z));
  program.setUniformValueArray(location("albedo"), values.data(), int(values.size()));
}

}  // namespace gonio::widgets

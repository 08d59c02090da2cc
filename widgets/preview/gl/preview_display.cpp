// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_display.h"

#include <QVector3D>

namespace gonio::widgets {

namespace {

QStringList definitionsOf(const PreviewComparison& comparison) {
  switch (comparison.mode) {
    case CompareMode::split:
      return {"COMPARE", "SPLIT"};
    case CompareMode::twoUp:
      return {"COMPARE", "TWO_UP"};
    case CompareMode::difference:
      return {"COMPARE", "DIFFERENCE",
              comparison.difference == DifferenceKind::relative      ? "RELATIVE"
              : comparison.difference == DifferenceKind::signedValue ? "SIGNED"
                                                                     : "ABSOLUTE"};
    case CompareMode::off:
    case CompareMode::flicker:
      break;
  }
  return {};
}

QVector3D toVector(const QColor& c) { return {float(c.redF()), float(c.greenF()), float(c.blueF())}; }

}  // namespace

void PreviewDisplay::clear(const DisplaySettings& settings) {
  const QVector3D colour = toVector(settings.backgroundEdge);
  glClearColor(colour.x(), colour.y(), colour.z(), 1);
  glClear(GL_COLOR_BUFFER_BIT);
}

void PreviewDisplay::bindPicture(QOpenGLShaderProgram& program, int unit, const char* name, const char* samples,
                                 const ShownPicture& picture) {
  glActiveTexture(GL_TEXTURE0 + GLenum(unit));
  glBindTexture(GL_TEXTURE_2D, picture.texture);
  // Linear: a first frame at half the resolution is stretched smoothly.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  program.setUniformValue(name, unit);
  program.setUniformValue(samples, picture.samples);
}

void PreviewDisplay::setSettings(QOpenGLShaderProgram& program, const QSize& viewport,
                                 const DisplaySettings& settings) {
  glViewport(0, 0, viewport.width(), viewport.height());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  program.setUniformValue("exposure", float(settings.exposure));
  program.setUniformValue("filmic", settings.toneMap == rendering::ToneMap::filmic);
  program.setUniformValue("backgroundCentre", toVector(settings.backgroundCentre));
  program.setUniformValue("backgroundEdge", toVector(settings.backgroundEdge));
  program.setUniformValue("checker", settings.checker);
}

void PreviewDisplay::present(const QSize& viewport, const DisplaySettings& settings, const ShownPicture& picture) {
  if (!picture.texture) return clear(settings);
  QOpenGLShaderProgram& program = resources_->program("preview/display.frag");
  program.bind();
  setSettings(program, viewport, settings);
  bindPicture(program, accumulationUnit, "accumulation", "samples", picture);
  resources_->drawFullscreen();
  program.release();
  glActiveTexture(GL_TEXTURE0);
}

void PreviewDisplay::present(const QSize& viewport, const DisplaySettings& settings,
                             const PreviewComparison& comparison, double range, const ShownPicture& first,
                             const ShownPicture& second) {
  const QStringList definitions = definitionsOf(comparison);
  if (definitions.isEmpty()) return present(viewport, settings, first);
  if (!first.texture || !second.texture) return clear(settings);
  QOpenGLShaderProgram& program = resources_->program("preview/display.frag", definitions);
  program.bind();
  setSettings(program, viewport, settings);
  bindPicture(program, accumulationUnit, "accumulation", "samples", first);
  bindPicture(program, otherAccumulationUnit, "otherAccumulation", "otherSamples", second);
  if (comparison.mode == CompareMode::split) program.setUniformValue("split", float(comparison.split));
  if (comparison.mode == CompareMode::difference) {
    resources_->bindColourMap(comparison.difference == DifferenceKind::signedValue);
    program.setUniformValue("colourMap", colourMapUnit);
    program.setUniformValue("range", float(range));
  }
  resources_->drawFullscreen();
  program.release();
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace gonio::widgets

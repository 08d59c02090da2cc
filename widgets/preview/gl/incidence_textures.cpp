// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/incidence_textures.h"

#include <algorithm>

#include "widgets/preview/gl/preview_resources.h"

namespace gonio::widgets {

namespace {

enum Texture : std::size_t { values, nodes };

}  // namespace

IncidenceTextures::IncidenceTextures(QOpenGLFunctions_4_1_Core& gl, const IncidenceTableBrdf& brdf) {
  const IncidenceTable& table = brdf.table();
  std::vector<float> texels;
  texels.reserve(4 * table.values.size());
  for (std::size_t i = 0; i < table.values.size(); ++i) {
    const glm::vec3 value = brdf.isAboveHorizon(i) ? table.values[i] : glm::vec3(0);
    texels.insert(texels.end(), {value.x, value.y, value.z, brdf.isAboveHorizon(i) ? 1.f : 0.f});
  }
  const std::vector<double>* axes[] = {&table.polars, &table.azimuths, &table.incident};
  for (int axis = 0; axis < 3; ++axis) counts_[axis] = GLint(axes[axis]->size());
  textures_.bind(gl, values, GL_TEXTURE_3D, tableUnit);
  uploadFloats(gl, 4, counts_[0], counts_[1], counts_[2], texels.data());

  const int width = *std::ranges::max_element(counts_);
  std::vector<float> angles(3 * std::size_t(width));
  for (std::size_t axis = 0; axis < 3; ++axis)
    std::ranges::transform(*axes[axis], angles.begin() + std::ptrdiff_t(axis) * width,
                           [](double angle) { return float(angle); });
  textures_.bind(gl, nodes, GL_TEXTURE_2D, baseNodeUnit);
  uploadFloats(gl, 1, width, 3, angles.data());
}

void IncidenceTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  textures_.bind(gl, values, GL_TEXTURE_3D, tableUnit);
  textures_.bind(gl, nodes, GL_TEXTURE_2D, baseNodeUnit);
  program.setUniformValue("incidenceValues", tableUnit);
  program.setUniformValue("incidenceNodes", baseNodeUnit);
  gl.glUniform3iv(program.uniformLocation("incidenceCounts"), 1, counts_);
}

bool IncidenceTextures::fits(const IncidenceTable& table) {
  constexpr std::size_t most = 2048;
  return std::max({table.polars.size(), table.azimuths.size(), table.incident.size()}) <= most;
}

QStringList IncidenceTextures::definitions(const IncidenceTable& table) {
  QStringList result{"INCIDENCE_TABLE"};
  if (table.axis == IncidenceTable::Axis::mirror) result << "INCIDENCE_TABLE_MIRROR";
  if (table.symmetric) result << "INCIDENCE_TABLE_SYMMETRIC";
  return result;
}

}  // namespace gonio::widgets

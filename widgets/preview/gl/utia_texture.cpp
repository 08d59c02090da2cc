// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/utia_texture.h"

#include "widgets/preview/gl/preview_resources.h"

namespace gonio::widgets {

UtiaTexture::UtiaTexture(QOpenGLFunctions_4_1_Core& gl, const UtiaBrdf::Values& values) {
  constexpr int side = int(UtiaBrdf::directionCount);
  std::vector<float> texels;
  texels.reserve(4 * values.size());
  for (const glm::vec3& value : values) texels.insert(texels.end(), {value.x, value.y, value.z, 1});
  texture_.bind(gl, 0, GL_TEXTURE_2D, tableUnit);
  uploadFloats(gl, 4, side, side, texels.data());
}

void UtiaTexture::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  texture_.bind(gl, 0, GL_TEXTURE_2D, tableUnit);
  program.setUniformValue("utiaValues", tableUnit);
}

}  // namespace gonio::widgets

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/rgl_textures.h"

#include "widgets/preview/gl/preview_resources.h"

namespace gonio::widgets {

namespace {

enum Other : std::size_t { colours, distribution, area };

void uploadPlane(QOpenGLFunctions_4_1_Core& gl, const SliceStack<float>& plane) {
  uploadFloats(gl, 1, int(plane.width), int(plane.height), plane.values.data());
}

}  // namespace

RglTextures::RglTextures(QOpenGLFunctions_4_1_Core& gl, std::shared_ptr<const RglBrdf::Tables> tables)
    : tables_(std::move(tables)) {
  const RglData& data = tables_->data;
  uploadWarp(gl, warp_, tables_->visibleNormals, tableUnit, rglRowUnit);
  const SliceStack<glm::vec3>& rgb = data.rgb;
  std::vector<float> texels;
  texels.reserve(4 * rgb.values.size());
  for (const glm::vec3& value : rgb.values) texels.insert(texels.end(), {value.x, value.y, value.z, 1});
  others_.bind(gl, colours, GL_TEXTURE_3D, rglColourUnit);
  uploadFloats(gl, 4, int(rgb.width), int(rgb.height), int(data.incident.slices()), texels.data());
  others_.bind(gl, distribution, GL_TEXTURE_2D, rglDistributionUnit);
  uploadPlane(gl, data.ndf);
  others_.bind(gl, area, GL_TEXTURE_2D, rglAreaUnit);
  uploadPlane(gl, data.sigma);
}

void RglTextures::bind(QOpenGLFunctions_4_1_Core& gl, QOpenGLShaderProgram& program) {
  warp_.bind(gl, 0, GL_TEXTURE_3D, tableUnit);
  warp_.bind(gl, 1, GL_TEXTURE_2D, rglRowUnit);
  others_.bind(gl, colours, GL_TEXTURE_3D, rglColourUnit);
  others_.bind(gl, distribution, GL_TEXTURE_2D, rglDistributionUnit);
  others_.bind(gl, area, GL_TEXTURE_2D, rglAreaUnit);
  program.setUniformValue("rglNormals", tableUnit);
  program.setUniformValue("rglRows", rglRowUnit);
  program.setUniformValue("rglColours", rglColourUnit);
  program.setUniformValue("rglDistribution", rglDistributionUnit);
  program.setUniformValue("rglArea", rglAreaUnit);
  const std::vector<float>&thetas = tables_->data.incident.thetas(), &phis = tables_->data.incident.phis();
  program.setUniformValueArray("rglThetas", thetas.data(), int(thetas.size()), 1);
  program.setUniformValueArray("rglPhis", phis.data(), int(phis.size()), 1);
}

QStringList RglTextures::definitions(const RglBrdf& brdf) {
  const RglData& data = brdf.tables()->data;
  QStringList result{QString("RGL_THETAS %1").arg(data.incident.thetas().size()),
                     QString("RGL_PHIS %1").arg(data.incident.phis().size()),
                     QString("RGL_REDUCTION %1").arg(data.azimuthReduction)};
  if (!data.isotropic) result << "RGL_ANISOTROPIC";
  if (data.jacobian) result << "RGL_JACOBIAN";
  return result;
}

}  // namespace gonio::widgets

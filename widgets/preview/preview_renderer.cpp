// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/preview_renderer.h"

#include <QMatrix3x3>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>
#include <algorithm>
#include <cmath>
#include <glm/vec4.hpp>

#include "core/support/error.h"
#include "widgets/preview/shader_library.h"
#include "widgets/preview/textures.h"

namespace gonio::widgets {

namespace {

constexpr int maxSamples = 64;  // of sphere.frag
enum TextureUnit { tableUnit, environmentUnit, lightPoolUnit, lightPoolRadianceUnit, accumulationUnit };

QVector3D toVector(const Direction& d) { return {float(d.x), float(d.y), float(d.z)}; }

std::unique_ptr<QOpenGLShaderProgram> link(const QByteArray& fragment, const char* name) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  if (!program->addShaderFromSourceCode(QOpenGLShader::Vertex, assembleShader("preview/fullscreen.vert")) ||
      !program->addShaderFromSourceCode(QOpenGLShader::Fragment, fragment) || !program->link())
    throw Error(std::string("shader ") + name + " was refused by the graphics driver: " + program->log().toStdString());
  return program;
}

void drawFullscreen(QOpenGLFunctions_4_1_Core& gl) { gl.glDrawArrays(GL_TRIANGLES, 0, 3); }

}  // namespace

PreviewRenderer::~PreviewRenderer() = default;

void PreviewRenderer::initialize() {
  if (!initializeOpenGLFunctions()) throw Error("the graphics driver does not offer OpenGL 4.1 core");
  glGenVertexArrays(1, &vertexArray_);
  displayProgram_ = link(assembleShader("preview/display.frag"), "preview/display.frag");
  initialized_ = true;
}

void PreviewRenderer::release() {
  if (!initialized_) return;
  for (GLuint* texture : {&tableTexture_, &environmentTexture_, &lightPoolTexture_, &lightPoolRadianceTexture_}) {
    if (*texture) glDeleteTextures(1, texture);
    *texture = 0;
  }
  glDeleteVertexArrays(1, &vertexArray_);
  programs_.clear();
  displayProgram_.reset();
  accumulation_.reset();
  uploadedEnvironment_.reset();
  initialized_ = false;
}

void PreviewRenderer::setTable(std::shared_ptr<const TabulatedBrdf> table, const SamplingLobe& lobe) {
  lobe_ = lobe;
  restart();
  if (!table) {
    if (tableTexture_) glDeleteTextures(1, &tableTexture_);
    tableTexture_ = 0;
    return;
  }
  phiPeriod_ = table->grid().phiDPeriod();
  uploadTable(*this, tableTexture_, *table);
}

void PreviewRenderer::setEdit(std::optional<editing::DifferentialEdit> edit) {
  edit_ = std::move(edit);
  if (edit_ && edit_->isIdentity()) edit_.reset();
  restart();
}

void PreviewRenderer::setLobe(const SamplingLobe& lobe) {
  lobe_ = lobe;
  restart();
}

void PreviewRenderer::setScene(const SphereScene& scene) {
  scene_ = scene;
  restart();
}

void PreviewRenderer::setSize(const QSize& size) {
  if (size == size_ && accumulation_) return;
  size_ = size.expandedTo({1, 1});
  accumulation_.reset();
  restart();
}

QOpenGLShaderProgram& PreviewRenderer::sphereProgram() {
  QStringList definitions, preamble;
  if (scene_.environment) definitions << "LIGHT_ENVIRONMENT";
  if (scene_.environment && scene_.showEnvironment) definitions << "SHOW_ENVIRONMENT";
  if (edit_) {
    const QString id = QString::fromUtf8(edit_->model->spec().id.data(), qsizetype(edit_->model->spec().id.size()));
    const auto count = edit_->model->shaderParameters(edit_->fitted).size();
    definitions << "EDIT_MODEL"
                << "EVALUATE_MODEL evaluate_" + QString(id).replace('-', '_')
                << QString("EDIT_PARAMETERS %1").arg(count);
    preamble << "models/" + id + ".glsl";
  }
  auto& program = programs_[definitions.join(' ')];
  if (!program) program = link(assembleShader("preview/sphere.frag", definitions, preamble), "preview/sphere.frag");
  return *program;
}

void PreviewRenderer::setCameraUniforms(QOpenGLShaderProgram& program) {
  const CameraFrame camera = cameraFrame(scene_.camera);
  QMatrix3x3 axes;
  for (int row = 0; row < 3; ++row) {
    axes(row, 0) = float(camera.right[row]);
    axes(row, 1) = float(camera.up[row]);
    axes(row, 2) = float(camera.forward[row]);
  }
  const glm::dvec2 extent = viewExtent(camera, double(size_.width()) / size_.height());
  program.setUniformValue("eye", toVector(camera.eye));
  program.setUniformValue("cameraAxes", axes);
  program.setUniformValue("viewExtent", QVector2D(float(extent.x), float(extent.y)));
  program.setUniformValue("orthographic", camera.orthographic);
  program.setUniformValue("pictureSize", QVector2D(float(size_.width()), float(size_.height())));
  if (!scene_.environment) {
    program.setUniformValue("toLight", toVector(scene_.light.toLight));
    program.setUniformValue("irradiance", toVector(scene_.light.irradiance));
  }
}

void PreviewRenderer::setEditUniforms(QOpenGLShaderProgram& program) {
  if (!edit_) return;
  const auto set = [&](const char* name, const models::ParameterValues& values) {
    const std::vector<glm::vec3> uniforms = edit_->model->shaderParameters(values);
    program.setUniformValueArray(name, &uniforms.front().x, int(uniforms.size()), 3);
  };
  set("editedParameters", edit_->edited);
  set("fittedParameters", edit_->fitted);
  program.setUniformValue("editStrength", float(edit_->strength));
}

void PreviewRenderer::setSampleUniforms(QOpenGLShaderProgram& program, int count) {
  QVector4D numbers[maxSamples];
  QVector2D offsets[maxSamples];
  constexpr int dimensions = 5;
  for (int i = 0; i < count; ++i) {
    const int index = samples_ + i;
    const auto number = [&](int d) { return float(additiveRecurrence(dimensions, d, index)); };
    numbers[i] = {number(0), number(1), number(2), float(index)};
    offsets[i] = {number(3) - 0.5f, number(4) - 0.5f};
  }
  program.setUniformValue("sampleCount", count);
  program.setUniformValueArray("sampleNumbers", numbers, count);
  program.setUniformValueArray("pixelOffsets", offsets, count);
}

void PreviewRenderer::uploadEnvironment() {
  if (!scene_.environment || scene_.environment == uploadedEnvironment_) return;
  uploadEnvironmentMap(*this, environmentTexture_, *scene_.environment);
  uploadLightPool(*this, lightPoolTexture_, lightPoolRadianceTexture_, *scene_.environment);
  uploadedEnvironment_ = scene_.environment;
}

void PreviewRenderer::bindTextures(QOpenGLShaderProgram& program) {
  glActiveTexture(GL_TEXTURE0 + tableUnit);
  glBindTexture(GL_TEXTURE_3D, tableTexture_);
  program.setUniformValue("table", tableUnit);
  program.setUniformValue("phiPeriod", float(phiPeriod_));
  if (!scene_.environment) return;
  glActiveTexture(GL_TEXTURE0 + environmentUnit);
  glBindTexture(GL_TEXTURE_2D, environmentTexture_);
  glActiveTexture(GL_TEXTURE0 + lightPoolUnit);
  glBindTexture(GL_TEXTURE_2D, lightPoolTexture_);
  glActiveTexture(GL_TEXTURE0 + lightPoolRadianceUnit);
  glBindTexture(GL_TEXTURE_2D, lightPoolRadianceTexture_);
  program.setUniformValue("environment", environmentUnit);
  program.setUniformValue("lightPool", lightPoolUnit);
  program.setUniformValue("lightPoolRadiance", lightPoolRadianceUnit);
  program.setUniformValue("environmentTurn", QVector2D(float(std::cos(scene_.environmentRotation)),
                                                       float(std::sin(scene_.environmentRotation))));
  program.setUniformValue("lobeRoughness", float(lobe_.roughness));
  program.setUniformValue("lobeSpecularShare", float(lobe_.specularShare));
}

void PreviewRenderer::accumulate(int count) {
  if (!hasMaterial() || count <= 0) return;
  count = std::min(count, maxSamples);
  if (!accumulation_) {
    accumulation_ = std::make_unique<QOpenGLFramebufferObject>(size_, QOpenGLFramebufferObject::NoAttachment,
                                                               GL_TEXTURE_2D, GL_RGBA32F);
    samples_ = 0;
  }
  glActiveTexture(GL_TEXTURE0 + environmentUnit);
  uploadEnvironment();
  QOpenGLShaderProgram& program = sphereProgram();
  accumulation_->bind();
  glViewport(0, 0, size_.width(), size_.height());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  if (samples_ == 0) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glBindVertexArray(vertexArray_);
  program.bind();
  bindTextures(program);
  setCameraUniforms(program);
  setEditUniforms(program);
  setSampleUniforms(program, count);
  drawFullscreen(*this);
  glDisable(GL_BLEND);
  glBindVertexArray(0);
  program.release();
  accumulation_->release();
  glFinish();
  samples_ += count;
}

void PreviewRenderer::present(const QSize& viewport, const Display& display) {
  glViewport(0, 0, viewport.width(), viewport.height());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  if (samples_ == 0 || !accumulation_) {
    glClearColor(float(display.backgroundEdge.redF()), float(display.backgroundEdge.greenF()),
                 float(display.backgroundEdge.blueF()), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    return;
  }
  glActiveTexture(GL_TEXTURE0 + accumulationUnit);
  glBindTexture(GL_TEXTURE_2D, accumulation_->texture());
  // Linear: a first frame at half the resolution is stretched smoothly.
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glBindVertexArray(vertexArray_);
  QOpenGLShaderProgram& program = *displayProgram_;
  program.bind();
  program.setUniformValue("accumulation", accumulationUnit);
  program.setUniformValue("samples", float(samples_));
  program.setUniformValue("exposure", float(display.exposure));
  program.setUniformValue("filmic", display.toneMap == ToneMap::filmic);
  const auto colour = [](const QColor& c) { return QVector3D(float(c.redF()), float(c.greenF()), float(c.blueF())); };
  program.setUniformValue("backgroundCentre", colour(display.backgroundCentre));
  program.setUniformValue("backgroundEdge", colour(display.backgroundEdge));
  drawFullscreen(*this);
  program.release();
  glBindVertexArray(0);
  glActiveTexture(GL_TEXTURE0);
}

Image PreviewRenderer::readPicture() {
  Image image(size_.width(), size_.height());
  image.alpha.assign(image.pixels.size(), 0.f);
  if (!accumulation_ || samples_ == 0) return image;
  std::vector<glm::vec4> texels(image.pixels.size());
  accumulation_->bind();
  glReadPixels(0, 0, size_.width(), size_.height(), GL_RGBA, GL_FLOAT, texels.data());
  accumulation_->release();
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) {
      const glm::vec4 mean = texels[image.index(x, image.height - 1 - y)] / float(samples_);
      image.at(x, y) = glm::vec3(mean);
      image.alpha[image.index(x, y)] = mean.a;
    }
  return image;
}

}  // namespace gonio::widgets

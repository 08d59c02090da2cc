// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/preview_renderer.h"

#include <QMatrix3x3>
#include <QVector2D>
#include <QVector3D>
#include <QVector4D>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/vec4.hpp>

#include "core/support/error.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

constexpr int maxSamples = 64;  // of scene.frag
// A pass in which rays search meshes is short: Mesa's software renderer leaves a shader's loops after 65,535 rounds.
constexpr int maxMeshSamples = 8;
constexpr double bandMilliseconds = 12;
constexpr int maxBands = 16;  // waiting for each has its cost too
QVector3D toVector(const Direction& d) { return {float(d.x), float(d.y), float(d.z)}; }

}  // namespace

PreviewRenderer::PreviewRenderer(std::shared_ptr<PreviewResources> resources) : resources_(std::move(resources)) {
  const rendering::Scene sphere = rendering::sphereScene();
  setScene(sphere, previewPlan(sphere, rendering::diffuseMaterial(Rgb(0.5))));
}

PreviewRenderer::~PreviewRenderer() = default;

void PreviewRenderer::initialize() {
  if (!resources_->isInitialized()) resources_->initialize();
  if (!initializeOpenGLFunctions()) throw Error(openGlTooOld);
}

void PreviewRenderer::release() {
  accumulation_.reset();
  QOpenGLFunctions_4_1_Core* const gl = resources_->isInitialized() ? this : nullptr;
  textures_.release(gl);
  for (SubjectTextures& other : otherTextures_) other.release(gl);
  if (resources_.use_count() == 1) resources_->release();
  restart();
}

void PreviewRenderer::setSubject(const PreviewSubject& subject) {
  subject_ = subject;
  restart();
}

bool PreviewRenderer::setScene(const rendering::Scene& scene, const rendering::EffectPlan& plan,
                               const std::vector<PreviewSubject>& otherSlotSubjects) {
  SceneUniforms uniforms(scene, plan);
  const auto sameMaterial = [](const PreviewSubject& a, const PreviewSubject& b) {
    return a.density == b.density && sameSubject(a, b);
  };
  const bool same = scene.camera == scene_.camera && scene.environment == scene_.environment &&
                    scene.environmentRotation == scene_.environmentRotation && uniforms == sceneUniforms_ &&
                    std::ranges::equal(otherSlotSubjects, otherSlotSubjects_, sameMaterial);
  scene_ = scene;
  otherSlotSubjects_ = otherSlotSubjects;
  sceneUniforms_ = std::move(uniforms);
  if (!same) {
    restart();
    rowMs_ = 0;
  }
  return !same;
}

std::unique_ptr<QOpenGLFramebufferObject> PreviewRenderer::takeBuffer() {
  restart();
  return std::move(accumulation_);
}

void PreviewRenderer::setSize(const QSize& size) {
  if (size == size_ && accumulation_) return;
  size_ = size.expandedTo({1, 1});
  accumulation_.reset();
  rowMs_ = 0;
  restart();
}

std::vector<PreviewRenderer::Pass> PreviewRenderer::passes() {
  while (otherTextures_.size() < otherSlotSubjects_.size()) otherTextures_.emplace_back();
  std::vector<Pass> all{{subject_, textures_, 1}};
  for (int slot = 1; slot < rendering::materialSlotCount(scene_); ++slot) {
    const auto other = std::size_t(slot - 1);
    if (other < otherSlotSubjects_.size() && !otherSlotSubjects_[other].isEmpty())
      all.push_back({otherSlotSubjects_[other], otherTextures_[other], 1 << slot});
    else
      all.front().slots |= 1 << slot;
  }
  return all;
}

QOpenGLShaderProgram& PreviewRenderer::sceneProgram(const PreviewSubject& subject, bool isOnly) {
  QStringList definitions = sceneUniforms_.definitions(), preamble;
  if (!isOnly) definitions << "SEVERAL_MATERIALS";
  SubjectTextures::addVariant(subject, definitions, preamble);
  return resources_->program("preview/scene.frag", definitions, preamble);
}

void PreviewRenderer::setCameraUniforms(QOpenGLShaderProgram& program) {
  const rendering::CameraFrame camera = rendering::cameraFrame(scene_.camera);
  QMatrix3x3 axes;
  for (int row = 0; row < 3; ++row) {
    axes(row, 0) = float(camera.right[row]);
    axes(row, 1) = float(camera.up[row]);
    axes(row, 2) = float(camera.forward[row]);
  }
  const glm::dvec2 extent = rendering::viewExtent(camera, double(size_.width()) / size_.height());
  program.setUniformValue("eye", toVector(camera.eye));
  program.setUniformValue("cameraAxes", axes);
  program.setUniformValue("viewExtent", QVector2D(float(extent.x), float(extent.y)));
  program.setUniformValue("orthographic", camera.orthographic);
  program.setUniformValue("pictureSize", QVector2D(float(size_.width()), float(size_.height())));
  sceneUniforms_.set(program);
}

void PreviewRenderer::setSampleUniforms(QOpenGLShaderProgram& program, int first, int count) {
  QVector4D numbers[maxSamples];
  QVector2D offsets[maxSamples];
  constexpr int dimensions = 5;
  for (int i = 0; i < count; ++i) {
    const int index = first + i;
    const auto number = [&](int d) { return float(additiveRecurrence(dimensions, d, index)); };
    numbers[i] = {number(0), number(1), number(2), float(index)};
    offsets[i] = {number(3) - 0.5f, number(4) - 0.5f};
  }
  program.setUniformValue("sampleCount", count);
  program.setUniformValueArray("sampleNumbers", numbers, count);
  program.setUniformValueArray("pixelOffsets", offsets, count);
}

void PreviewRenderer::bindTextures(QOpenGLShaderProgram& program) {
  if (!sceneUniforms_.meshes().empty()) resources_->bindMeshes(program, sceneUniforms_.meshes());
  if (!sceneUniforms_.usesEnvironment()) return;
  resources_->bindEnvironment(scene_.environment);
  program.setUniformValue("environment", environmentUnit);
  program.setUniformValue("lightPool", lightPoolUnit);
  program.setUniformValue("lightPoolRadiance", lightPoolRadianceUnit);
  program.setUniformValue("environmentTurn", QVector2D(float(std::cos(scene_.environmentRotation)),
                                                       float(std::sin(scene_.environmentRotation))));
}

/// Unbinds the texture of the active unit: comes before textures are bound.
void PreviewRenderer::createTarget() {
  if (accumulation_) return;
  accumulation_ = std::make_unique<QOpenGLFramebufferObject>(size_, QOpenGLFramebufferObject::NoAttachment,
                                                             GL_TEXTURE_2D, GL_RGBA32F);
  accumulation_->addColorAttachment(size_, GL_RGBA32F);
  samples_ = 0;
}

void PreviewRenderer::prepareTarget(bool isFirstPass) {
  accumulation_->bind();
  constexpr GLenum outputs[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glDrawBuffers(2, outputs);
  glViewport(0, 0, size_.width(), size_.height());
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  if (samples_ == 0 && isFirstPass) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
  }
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

bool PreviewRenderer::accumulate(int count, const std::function<bool()>& isObsolete) {
  if (!hasMaterial() || count <= 0) return true;
  createTarget();
  const std::vector<Pass> all = passes();
  if (all.size() == 1) return addSamples(all.front(), true, count, isObsolete);
  const int before = samples_;
  for (const Pass& pass : all) {
    samples_ = before;
    addSamples(pass, false, count, {});
  }
  return true;
}

bool PreviewRenderer::addSamples(const Pass& pass, bool isOnly, int count, const std::function<bool()>& isObsolete) {
  QOpenGLShaderProgram& program = sceneProgram(pass.subject, isOnly);
  program.bind();
  pass.textures.bind(*this, program, *resources_, pass.subject, sceneUniforms_.samplesDirections());
  bindTextures(program);
  setCameraUniforms(program);
  if (!isOnly) program.setUniformValue("drawnSlots", pass.slots);
  prepareTarget(&pass.subject == &subject_);
  const int most = sceneUniforms_.meshes().empty() ? maxSamples : maxMeshSamples;
  int rows = size_.height();
  for (int done = 0, now = 0; done < count && rows == size_.height(); done += now) {
    now = std::min(most, count - done);
    setSampleUniforms(program, samples_, now);
    rows = drawInBands(now, isObsolete);
    if (rows == size_.height())
      samples_ += now;
    else
      takeBack(program, rows, now);
  }
  glDisable(GL_BLEND);
  program.release();
  accumulation_->release();
  return rows == size_.height();
}

/// The time of a band decides how many rows the next one has, that of the last pass the rows of the first band.
/// @returns the number of rows drawn.
int PreviewRenderer::drawInBands(int samples, const std::function<bool()>& isObsolete) {
  using Clock = std::chrono::steady_clock;
  glEnable(GL_SCISSOR_TEST);
  const int minRows = (size_.height() + maxBands - 1) / maxBands;
  const auto milliseconds = [](Clock::time_point since) {
    return std::chrono::duration<double, std::milli>(Clock::now() - since).count();
  };
  const auto rowsLike = [&](double rows, double taken) {
    return std::clamp(int(rows * bandMilliseconds / std::max(taken, 1e-3)), minRows, size_.height());
  };
  int row = 0, rows = rowMs_ > 0 ? rowsLike(1, rowMs_ * samples) : 2 * minRows;
  const Clock::time_point first = Clock::now();
  while (row < size_.height()) {
    rows = std::min(rows, size_.height() - row);
    const Clock::time_point start = Clock::now();
    glScissor(0, row, size_.width(), rows);
    resources_->drawFullscreen();
    glFinish();
    row += rows;
    rows = std::min(4 * rows, rowsLike(rows, milliseconds(start)));
    if (isObsolete && row < size_.height() && isObsolete()) break;
  }
  rowMs_ = milliseconds(first) / (row * samples);
  glDisable(GL_SCISSOR_TEST);
  return row;
}

/// The lower rows have more samples than the others: their sums become those of as many.
void PreviewRenderer::takeBack(QOpenGLShaderProgram& program, int rows, int samples) {
  if (samples_ == 0) return;  // the next pass clears it
  program.setUniformValue("sampleCount", 0);
  const float share = float(samples_) / float(samples_ + samples);
  glBlendColor(share, share, share, share);
  glBlendFunc(GL_ZERO, GL_CONSTANT_COLOR);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, size_.width(), rows);
  resources_->drawFullscreen();
  glDisable(GL_SCISSOR_TEST);
}

void PreviewRenderer::showTraced(const rendering::Film& film) {
  setSize({film.width, film.height});
  createTarget();
  std::vector<glm::vec4> texels, features;
  texels.reserve(film.radiance.size());
  features.reserve(film.radiance.size());
  for (int y = film.height - 1; y >= 0; --y)
    for (int x = 0; x < film.width; ++x) {
      const std::size_t index = std::size_t(y) * std::size_t(film.width) + std::size_t(x);
      texels.emplace_back(film.radiance[index], film.coverage[index]);
      features.push_back(film.features.empty() ? glm::vec4(0) : film.features[index]);
    }
  glActiveTexture(GL_TEXTURE0 + accumulationUnit);
  const auto upload = [&](GLuint texture, const std::vector<glm::vec4>& values) {
    glBindTexture(GL_TEXTURE_2D, texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, film.width, film.height, GL_RGBA, GL_FLOAT, values.data());
  };
  upload(accumulation_->texture(), texels);
  upload(accumulation_->textures()[1], features);
  samples_ = film.samples;
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

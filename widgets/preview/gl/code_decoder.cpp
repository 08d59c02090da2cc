// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/code_decoder.h"

#include <QByteArray>
#include <QVector3D>
#include <algorithm>
#include <array>

#include "core/dictionary/decode.h"
#include "core/dictionary/signals.h"
#include "core/support/error.h"
#include "widgets/preview/gl/program_cache.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

namespace {

/// The places of a channel's groups and slabs among its sorted coefficients.
struct ChannelRanges {
  std::vector<glm::vec4> groups, slabs;
  std::vector<int> thetaHAtoms;  ///< of the slabs
};

ChannelRanges appendSorted(const dictionary::ChannelCode& channel, const dictionary::Sizes& sizes,
                           std::vector<glm::vec2>& all) {
  auto sorted = channel.coefficients;
  std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.index < b.index; });
  ChannelRanges ranges;
  int lastPair = -1;
  for (const auto& c : sorted) {
    const int pair = int(c.index) / sizes[0], thetaH = pair / sizes[1];
    if (ranges.thetaHAtoms.empty() || ranges.thetaHAtoms.back() != thetaH) {
      ranges.slabs.emplace_back(ranges.groups.size(), 0, 0, 0);
      ranges.thetaHAtoms.push_back(thetaH);
    }
    if (pair != lastPair) ranges.groups.emplace_back(pair % sizes[1], all.size(), 0, 0);
    lastPair = pair;
    all.emplace_back(int(c.index) % sizes[0], c.value);
    ranges.groups.back().z = float(all.size());
    ranges.slabs.back().y = float(ranges.groups.size());
  }
  return ranges;
}

void setThetaHAtoms(CodeTexels& texels, int channel, const Eigen::MatrixXd& atoms, const std::vector<int>& used) {
  constexpr int layers = CodeTexels::layersAtOnce;
  for (int node = 0; node < int(atoms.rows()); ++node) {
    const int row = (channel * texels.blocks() + node / layers) * 2 + node % layers / 4;
    glm::vec4* const line = texels.thetaHAtoms.data() + std::ptrdiff_t(row) * texels.slabs;
    for (std::size_t slab = 0; slab < used.size(); ++slab) line[slab][node % 4] = float(atoms(node, used[slab]));
  }
}

}  // namespace

CodeTexels codeTexels(const dictionary::Ensemble& ensemble, const dictionary::SparseCode& code) {
  dictionary::checkCode(ensemble, code);
  const dictionary::Sizes sizes = dictionary::modeSizes(code.grid);
  CodeTexels texels;
  texels.grid = code.grid;
  texels.transform = code.transform;
  std::array<ChannelRanges, 3> ranges;
  for (std::size_t c = 0; c < 3; ++c) {
    texels.highest[c] = code.channels[c].highest;
    texels.lowest[c] = code.channels[c].lowest;
    texels.largestValue[c] = code.channels[c].largestValue;
    ranges[c] = appendSorted(code.channels[c], sizes, texels.coefficients);
    texels.groups = std::max({texels.groups, int(ranges[c].groups.size()), 1});
    texels.slabs = std::max({texels.slabs, int(ranges[c].slabs.size()), 1});
  }
  if (texels.coefficients.empty()) texels.coefficients.emplace_back(0);
  texels.thetaHAtoms.resize(std::size_t(3 * texels.blocks() * 2 * texels.slabs), glm::vec4(0));
  const auto geometry = dictionary::GridGeometry::of(code.grid);
  for (std::size_t c = 0; c < 3; ++c) {
    for (auto* const list : {&ranges[c].groups, &ranges[c].slabs})
      list->resize(std::size_t(list == &ranges[c].groups ? texels.groups : texels.slabs), glm::vec4(0));
    texels.groupRanges.insert(texels.groupRanges.end(), ranges[c].groups.begin(), ranges[c].groups.end());
    texels.slabRanges.insert(texels.slabRanges.end(), ranges[c].slabs.begin(), ranges[c].slabs.end());
    const auto atoms = dictionary::unscaledAtoms(dictionaryOf(ensemble, code, c), *geometry, code.scaled);
    for (std::size_t mode = 0; mode < 2; ++mode) {
      const Eigen::MatrixXf single = atoms[mode].cast<float>();
      texels.atoms[mode].insert(texels.atoms[mode].end(), single.data(), single.data() + single.size());
    }
    setThetaHAtoms(texels, int(c), atoms[2], ranges[c].thetaHAtoms);
  }
  return texels;
}

namespace {

using Gl = QOpenGLFunctions_4_1_Core;

/// Puts back what drawing into textures changes.
class KeptState {
 public:
  explicit KeptState(Gl& gl) : gl_(gl) {
    gl.glGetIntegerv(GL_ACTIVE_TEXTURE, &activeTexture_);
    gl.glGetIntegerv(GL_CURRENT_PROGRAM, &program_);
    gl.glGetIntegerv(GL_FRAMEBUFFER_BINDING, &framebuffer_);
    gl.glGetIntegerv(GL_VIEWPORT, viewport_.data());
    for (std::size_t i = 0; i < capabilities.size(); ++i) {
      enabled_[i] = gl.glIsEnabled(capabilities[i]);
      gl.glDisable(capabilities[i]);
    }
  }
  ~KeptState() {
    for (std::size_t i = 0; i < capabilities.size(); ++i)
      if (enabled_[i]) gl_.glEnable(capabilities[i]);
    gl_.glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, GLuint(framebuffer_));
    gl_.glUseProgram(GLuint(program_));
    gl_.glActiveTexture(GLenum(activeTexture_));
  }
  KeptState(const KeptState&) = delete;
  KeptState& operator=(const KeptState&) = delete;

 private:
  static constexpr std::array<GLenum, 4> capabilities{GL_BLEND, GL_DEPTH_TEST, GL_CULL_FACE, GL_SCISSOR_TEST};
  Gl& gl_;
  GLint activeTexture_ = 0, program_ = 0, framebuffer_ = 0;
  std::array<GLint, 4> viewport_{};
  std::array<GLboolean, 4> enabled_{};
};

/// Textures, buffers and the framebuffer of one decoding.
class Passes {
 public:
  explicit Passes(Gl& gl) : gl_(gl) { gl.glGenFramebuffers(1, &framebuffer_); }
  ~Passes() {
    gl_.glDeleteFramebuffers(1, &framebuffer_);
    gl_.glDeleteTextures(GLsizei(textures_.size()), textures_.data());
    gl_.glDeleteBuffers(GLsizei(buffers_.size()), buffers_.data());
  }
  Passes(const Passes&) = delete;
  Passes& operator=(const Passes&) = delete;

  GLuint picture(GLint internalFormat, GLenum format, int width, int height, const void* texels = nullptr) {
    const GLuint texture = made(GL_TEXTURE_2D);
    gl_.glTexImage2D(GL_TEXTURE_2D, 0, internalFormat, width, height, 0, format, GL_FLOAT, texels);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
  }

  template <typename Texel>
  GLuint list(GLenum format, const std::vector<Texel>& texels) {
    const GLuint texture = made(GL_TEXTURE_BUFFER);
    GLuint buffer = 0;
    gl_.glGenBuffers(1, &buffer);
    buffers_.push_back(buffer);
    gl_.glBindBuffer(GL_TEXTURE_BUFFER, buffer);
    gl_.glBufferData(GL_TEXTURE_BUFFER, GLsizeiptr(texels.size() * sizeof(Texel)), texels.data(), GL_STREAM_DRAW);
    gl_.glTexBuffer(GL_TEXTURE_BUFFER, format, buffer);
    gl_.glBindBuffer(GL_TEXTURE_BUFFER, 0);
    return texture;
  }

  struct Source {
    const char* name;
    GLenum target;
    GLuint texture;
  };
  void read(QOpenGLShaderProgram& program, std::initializer_list<Source> sources) {
    program.bind();
    GLint unit = firstDecoderUnit;
    for (const Source& source : sources) {
      gl_.glActiveTexture(GL_TEXTURE0 + GLenum(unit));
      gl_.glBindTexture(source.target, source.texture);
      program.setUniformValue(source.name, unit++);
    }
  }

  /// From now on it is drawn into a picture, or into so many layers of a table.
  void drawInto(GLuint picture, int width, int height) {
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    gl_.glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0);
    prepare(1, width, height);
  }
  void drawInto(GLuint table, const HalfDifferenceGrid& grid, int firstLayer) {
    gl_.glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    const int count = std::min(CodeTexels::layersAtOnce, grid.thetaHCount - firstLayer);
    for (int i = 0; i < CodeTexels::layersAtOnce; ++i)
      gl_.glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + GLenum(i), i < count ? table : 0, 0,
                                    firstLayer + i);
    prepare(count, grid.phiDCount, grid.thetaDCount);
  }

 private:
  GLuint made(GLenum target) {
    GLuint texture = 0;
    gl_.glGenTextures(1, &texture);
    textures_.push_back(texture);
    gl_.glActiveTexture(GL_TEXTURE0 + firstDecoderUnit);
    gl_.glBindTexture(target, texture);
    return texture;
  }
  void prepare(int count, int width, int height) {
    std::array<GLenum, CodeTexels::layersAtOnce> targets;
    for (std::size_t i = 0; i < targets.size(); ++i) targets[i] = GL_COLOR_ATTACHMENT0 + GLenum(i);
    gl_.glDrawBuffers(count, targets.data());
    gl_.glViewport(0, 0, width, height);
    if (gl_.glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
      throw Error("the graphics driver cannot render to floating-point textures");
  }

  Gl& gl_;
  GLuint framebuffer_ = 0;
  std::vector<GLuint> textures_, buffers_;
};

}  // namespace

bool CodeDecoder::fits(Gl& gl, const CodeTexels& texels) {
  GLint side = 0, listed = 0;
  gl.glGetIntegerv(GL_MAX_TEXTURE_SIZE, &side);
  gl.glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &listed);
  const HalfDifferenceGrid& grid = texels.grid;
  return std::max({texels.groups, texels.slabs * grid.thetaDCount, 3 * grid.phiDCount, 3 * grid.thetaDCount}) <= side &&
         std::max(texels.coefficients.size(), texels.groupRanges.size()) <= std::size_t(listed);
}

bool CodeDecoder::isSoftware(Gl& gl) {
  const QByteArray renderer = QByteArray(reinterpret_cast<const char*>(gl.glGetString(GL_RENDERER))).toLower();
  for (const char* name : {"llvmpipe", "softpipe", "swrast", "swr ", "swiftshader", "software", "basic render"})
    if (renderer.contains(name)) return true;
  return false;
}

void CodeDecoder::bindWeights(Gl& gl, const HalfDifferenceGrid& grid) {
  gl.glActiveTexture(GL_TEXTURE0 + firstDecoderUnit);
  if (weights_ == 0) gl.glGenTextures(1, &weights_);
  gl.glBindTexture(GL_TEXTURE_3D, weights_);
  if (weightsGrid_ == grid) return;
  const auto geometry = dictionary::GridGeometry::of(grid);
  std::vector<float> weights(grid.size());
  for (std::size_t i = 0; i < weights.size(); ++i)
    weights[i] = geometry->aboveHorizon[i] ? geometry->weights[Eigen::Index(i)] : 0;
  gl.glTexImage3D(GL_TEXTURE_3D, 0, GL_R32F, grid.phiDCount, grid.thetaDCount, grid.thetaHCount, 0, GL_RED, GL_FLOAT,
                  weights.data());
  gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  weightsGrid_ = grid;
}

void CodeDecoder::decode(Gl& gl, ProgramCache& programs, const CodeTexels& texels, GLuint& texture) {
  const HalfDifferenceGrid& grid = texels.grid;
  setTableTexels(gl, texture, grid, nullptr);
  const KeptState kept(gl);
  Passes passes(gl);
  bindWeights(gl, grid);
  gl.glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const GLuint groupRanges = passes.list(GL_RGBA32F, texels.groupRanges);
  const auto atoms = [&](std::size_t mode, int size) {
    return passes.picture(GL_R32F, GL_RED, size, 3 * size, texels.atoms[mode].data());
  };

  QOpenGLShaderProgram& fibreProgram = programs.program("preview/decode_fibres.frag");
  const GLuint fibres = passes.picture(GL_RGBA32F, GL_RGBA, grid.phiDCount, texels.groups);
  passes.drawInto(fibres, grid.phiDCount, texels.groups);
  passes.read(fibreProgram, {{"coefficients", GL_TEXTURE_BUFFER, passes.list(GL_RG32F, texels.coefficients)},
                             {"groupRanges", GL_TEXTURE_BUFFER, groupRanges},
                             {"phiDAtoms", GL_TEXTURE_2D, atoms(0, grid.phiDCount)}});
  fibreProgram.setUniformValue("groupCount", texels.groups);
  programs.drawFullscreen(gl);

  QOpenGLShaderProgram& slabProgram = programs.program("preview/decode_slabs.frag");
  const int slabRows = texels.slabs * grid.thetaDCount;
  const GLuint slabs = passes.picture(GL_RGBA32F, GL_RGBA, grid.phiDCount, slabRows);
  passes.drawInto(slabs, grid.phiDCount, slabRows);
  passes.read(slabProgram, {{"slabRanges", GL_TEXTURE_BUFFER, passes.list(GL_RGBA32F, texels.slabRanges)},
                            {"groupRanges", GL_TEXTURE_BUFFER, groupRanges},
                            {"fibres", GL_TEXTURE_2D, fibres},
                            {"thetaDAtoms", GL_TEXTURE_2D, atoms(1, grid.thetaDCount)}});
  slabProgram.setUniformValue("groupCount", texels.groups);
  slabProgram.setUniformValue("slabCount", texels.slabs);
  programs.drawFullscreen(gl);

  QOpenGLShaderProgram& tableProgram =
      programs.program("preview/decode_table.frag", {QString("TRANSFORM %1").arg(int(texels.transform))});
  const GLuint thetaHAtoms =
      passes.picture(GL_RGBA32F, GL_RGBA, texels.slabs, 3 * 2 * texels.blocks(), texels.thetaHAtoms.data());
  passes.read(tableProgram, {{"slabs", GL_TEXTURE_2D, slabs},
                             {"thetaHAtoms", GL_TEXTURE_2D, thetaHAtoms},
                             {"weights", GL_TEXTURE_3D, weights_}});
  tableProgram.setUniformValue("highest", QVector3D(texels.highest[0], texels.highest[1], texels.highest[2]));
  tableProgram.setUniformValue("lowest", QVector3D(texels.lowest[0], texels.lowest[1], texels.lowest[2]));
  tableProgram.setUniformValue("largestValue",
                               QVector3D(texels.largestValue[0], texels.largestValue[1], texels.largestValue[2]));
  for (int block = 0; block < texels.blocks(); ++block) {
    passes.drawInto(texture, grid, block * CodeTexels::layersAtOnce);
    tableProgram.setUniformValue("block", block);
    programs.drawFullscreen(gl);
  }
}

void CodeDecoder::release(Gl& gl) {
  if (weights_) gl.glDeleteTextures(1, &weights_);
  *this = {};
}

}  // namespace gonio::widgets

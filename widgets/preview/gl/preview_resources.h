// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#pragma once

#include <QOpenGLFunctions_4_1_Core>
#include <QOpenGLShaderProgram>
#include <functional>
#include <map>
#include <memory>

#include "core/brdf/tabulated_brdf.h"
#include "core/interpolation/interpolation.h"
#include "core/rendering/environment.h"
#include "widgets/preview/gl/code_decoder.h"
#include "widgets/preview/gl/mesh_texture.h"
#include "widgets/preview/gl/program_cache.h"
#include "widgets/preview/gl/shader_base.h"
#include "widgets/preview/gl/textures.h"

namespace gonio::widgets {

/// A table on the graphics card. The context must be current when it is destroyed.
struct TableTexture {
  GLuint name = 0;
  double phiPeriod = 0;

  TableTexture() = default;
  TableTexture(const TableTexture&) = delete;
  TableTexture& operator=(const TableTexture&) = delete;
  ~TableTexture();
};

/// The tables of a mixture, in the order of the materials. The context must be current when they are destroyed.
struct MixtureTextures {
  std::vector<std::unique_ptr<TableTexture>> tables;
};

/// Resources shared by all pictures of one OpenGL context: linked shaders, the textures of the environment and of
/// meshes, tables. All calls need that context to be current.
class PreviewResources : protected QOpenGLFunctions_4_1_Core {
 public:
  /// @throws Error if the context has no OpenGL 4.1 core functions.
  void initialize();
  bool isInitialized() const { return initialized_; }
  /// Frees everything that belongs to the context.
  void release();

  /// ProgramCache::program()
  QOpenGLShaderProgram& program(const QString& fragment, const QStringList& definitions = {},
                                const QStringList& preamble = {}) {
    return programs_.program(fragment, definitions, preamble);
  }
  /// The listener is called before a program is compiled, which can take a second.
  void setCompileListener(std::function<void()> listener) { programs_.setCompileListener(std::move(listener)); }
  /// Whether programs are transformed by withFlatUniforms(). By default only with software OpenGL. The setter frees all
  /// programs.
  void setUsesFlatUniforms(bool uses);
  /// Draws the whole viewport with the bound program.
  void drawFullscreen() { programs_.drawFullscreen(*this); }

  /// The texture of a table, uploaded at first use (about 20 ms for 90 x 90 x 180). If a code is given, the card
  /// decodes it instead, provided that decodesCodes() and the code fits its textures.
  std::shared_ptr<const TableTexture> table(const std::shared_ptr<const TabulatedBrdf>& table,
                                            const std::shared_ptr<const EnsembleCode>& code = nullptr);
  /// A base that is not a table, uploaded at first use (a few ms); shared by all its incident directions
  /// (IncidentDirection).
  std::shared_ptr<ShaderBase> base(const std::shared_ptr<const Brdf>& base);
  /// The textures of all tables of a mixture, uploaded at first use. @param codes if not null: tables on the same grid,
  /// which the textures contain above the others along theta_h (16 texture units are too few for twice as many
  /// textures).
  std::shared_ptr<const MixtureTextures> mixture(
      const std::shared_ptr<const interpolation::TransformedMixture>& mixture,
      const std::shared_ptr<const interpolation::TransformedMixture>& codes = nullptr);
  /// Whether codes are decoded on the card. By default true, except with software OpenGL (CodeDecoder::isSoftware()).
  bool decodesCodes() const { return decodesCodes_; }
  void setDecodesCodes(bool decodes) { decodesCodes_ = decodes; }
  /// Binds the environment's pictures to their units; uploads them if the environment changed.
  void bindEnvironment(const std::shared_ptr<const rendering::EnvironmentMap>& environment);
  /// Binds a scene's meshes; uploads them if they changed.
  void bindMeshes(QOpenGLShaderProgram& program, const std::vector<rendering::MeshShape>& meshes);
  /// Binds viridis or the signed map (core/rendering/error_maps.h) to its unit.
  void bindColourMap(bool isSigned);

 private:
  void uploadColourMap(bool isSigned);
  bool decode(const EnsembleCode& code, GLuint& texture);

  CodeDecoder decoder_;
  ProgramCache programs_;
  bool initialized_ = false, decodesCodes_ = false;
  GLuint environmentTexture_ = 0, lightPoolTexture_ = 0, lightPoolRadianceTexture_ = 0;
  GLuint colourMaps_[2] = {0, 0};
  std::map<std::weak_ptr<const TabulatedBrdf>, std::weak_ptr<const TableTexture>, std::owner_less<>> tables_;
  std::map<std::weak_ptr<const void>, std::weak_ptr<ShaderBase>, std::owner_less<>> bases_;
  std::map<std::weak_ptr<const interpolation::TransformedMixture>, std::weak_ptr<const MixtureTextures>,
           std::owner_less<>>
      mixtures_;
  std::shared_ptr<const rendering::EnvironmentMap> uploadedEnvironment_;
  std::vector<rendering::MeshShape> uploadedMeshes_;
  std::unique_ptr<MeshTexture> meshTexture_;
};

}  // namespace gonio::widgets

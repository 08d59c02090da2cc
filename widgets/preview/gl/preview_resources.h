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
#include "widgets/preview/gl/shader_base.h"

namespace gonio::widgets {

enum TextureUnit {
  tableUnit,
  environmentUnit,
  lightPoolUnit,
  lightPoolRadianceUnit,
  accumulationUnit,
  otherAccumulationUnit,
  colourMapUnit,
  factorUnit,
  firstBlendUnit,  ///< and those after it, one per material
  endOfBlendUnits = firstBlendUnit + 4,
  firstDecoderUnit = endOfBlendUnits,  ///< and three after it: the last of the 16 that every card has
  // Units of the pass that displays pictures and of the decoder are free while a picture is drawn. An RGL file may
  // stand beside the tables of a blend; its visible normals are in the place of the table.
  rglRowUnit = accumulationUnit,
  rglColourUnit = otherAccumulationUnit,
  rglDistributionUnit = firstDecoderUnit + 2,
  rglAreaUnit = firstDecoderUnit + 3,
  baseNodeUnit = firstBlendUnit,  ///< nodes of a table of angles of incidence, which is shown alone too
  // While a picture is drawn nothing is decoded.
  lobeCellUnit = firstDecoderUnit,
  lobeRowUnit,
  meshUnit = colourMapUnit,
};

/// A table on the graphics card; freed with its last user, in whose hands the context must be current.
struct TableTexture {
  GLuint name = 0;
  double phiPeriod = 0;

  TableTexture() = default;
  TableTexture(const TableTexture&) = delete;
  TableTexture& operator=(const TableTexture&) = delete;
  ~TableTexture();
};

/// The tables of a mixture, in the order of the materials; as TableTexture.
struct MixtureTextures {
  std::vector<std::unique_ptr<TableTexture>> tables;
};

/// What all pictures of one OpenGL context share: linked shaders, the textures of the environment and of meshes, tables
/// that several pictures show. Every call needs that context to be current.
class PreviewResources : protected QOpenGLFunctions_4_1_Core {
 public:
  /// @throws Error when the context has no OpenGL 4.1 core functions.
  void initialize();
  bool isInitialized() const { return initialized_; }
  /// Frees everything that belongs to the context.
  void release();

  /// A fullscreen pass with the given fragment shader, assembled and linked at its first use.
  /// @throws Error with the compiler's log.
  QOpenGLShaderProgram& program(const QString& fragment, const QStringList& definitions = {},
                                const QStringList& preamble = {});
  /// Called before a program is compiled: that takes up to a second.
  void setCompileListener(std::function<void()> listener) { compileListener_ = std::move(listener); }
  /// Whether programs are linked as withFlatUniforms() makes them. At first it is so under software OpenGL alone. Frees
  /// all programs.
  void setUsesFlatUniforms(bool uses);
  /// Draws the bound program over the viewport.
  void drawFullscreen();

  /// Uploads at the first use (about 20 ms for 90 x 90 x 180). What was decoded from a code that is given, the card
  /// decodes for itself where it does so and its textures are large enough.
  std::shared_ptr<const TableTexture> table(const std::shared_ptr<const TabulatedBrdf>& table,
                                            const std::shared_ptr<const EnsembleCode>& code = nullptr);
  /// What is no table: uploads at the first use, whatever the order of the directions (some ms).
  std::shared_ptr<ShaderBase> base(const std::shared_ptr<const Brdf>& base);
  /// The same of each table of a mixture.
  std::shared_ptr<const MixtureTextures> mixture(const std::shared_ptr<const editing::TransformedMixture>& mixture);
  /// Whether codes are decoded on the card. At first it is so but under software OpenGL (CodeDecoder::isSoftware()).
  bool decodesCodes() const { return decodesCodes_; }
  void setDecodesCodes(bool decodes) { decodesCodes_ = decodes; }
  /// Binds the environment's pictures to their units, uploading them when it is another one than before.
  void bindEnvironment(const std::shared_ptr<const EnvironmentMap>& environment);
  /// Binds a scene's meshes, uploading them when they are others than before.
  void bindMeshes(QOpenGLShaderProgram& program, const std::vector<MeshShape>& meshes);
  /// Binds viridis or the signed map (core/rendering/false_colour.h) to its unit.
  void bindColourMap(bool isSigned);

 private:
  void uploadColourMap(bool isSigned);
  bool decode(const EnsembleCode& code, GLuint& texture);

  CodeDecoder decoder_;
  std::function<void()> compileListener_;
  bool initialized_ = false, decodesCodes_ = false, usesFlatUniforms_ = false;
  int flatVectors_ = 0;
  GLuint vertexArray_ = 0, environmentTexture_ = 0, lightPoolTexture_ = 0, lightPoolRadianceTexture_ = 0;
  GLuint colourMaps_[2] = {0, 0};
  std::map<QString, std::unique_ptr<QOpenGLShaderProgram>> programs_;
  std::map<std::weak_ptr<const TabulatedBrdf>, std::weak_ptr<const TableTexture>, std::owner_less<>> tables_;
  std::map<std::weak_ptr<const void>, std::weak_ptr<ShaderBase>, std::owner_less<>> bases_;
  std::map<std::weak_ptr<const editing::TransformedMixture>, std::weak_ptr<const MixtureTextures>, std::owner_less<>>
      mixtures_;
  std::shared_ptr<const EnvironmentMap> uploadedEnvironment_;
  std::vector<MeshShape> uploadedMeshes_;
  std::unique_ptr<MeshTexture> meshTexture_;
};

}  // namespace gonio::widgets

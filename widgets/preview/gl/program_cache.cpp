// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/preview/gl/program_cache.h"

#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>
#include <algorithm>
#include <optional>
#include <vector>

#include "core/support/error.h"
#include "widgets/preview/gl/shader_library.h"

namespace gonio::widgets {

namespace {

struct Uniform {
  QString type, name;
  int length = 0;  ///< 0: no array

  int vectors() const { return (type == "mat3" ? 3 : 1) * std::max(1, length); }
  QString declared(const QString& as) const {
    return type + ' ' + as + (length > 0 ? QString("[%1]").arg(length) : QString());
  }
};

/// Loops over so many elements are unrolled: their arrays are indexed by constants.
constexpr int maxSceneArray = 4;

/// Lengths by the names of their macros.
using Lengths = QHash<QString, int>;

/// -1 where the length is not known, or too long to be moved.
int lengthOf(const QString& text, const Lengths& lengths) {
  if (text.isEmpty()) return 0;
  bool isNumber = false;
  const int number = text.toInt(&isNumber);
  if (isNumber) return number;
  const int length = lengths.value(text, -1);
  return length <= maxSceneArray ? length : -1;
}

/// The uniforms of a line that declares only uniforms which can be moved; empty for other lines.
std::vector<Uniform> movableUniforms(const QString& line, const Lengths& lengths) {
  static const QRegularExpression declaration("^uniform (float|vec2|vec3|vec4|mat3) ([^;]+);");
  static const QRegularExpression declarator("^(\\w+)(?:\\[(\\w+)\\])?$");
  const auto match = declaration.match(line);
  std::vector<Uniform> uniforms;
  if (!match.hasMatch()) return uniforms;
  for (const QString& part : match.captured(2).split(',')) {
    const auto one = declarator.match(part.trimmed());
    const int length = one.hasMatch() ? lengthOf(one.captured(2), lengths) : -1;
    if (length < 0) return {};
    uniforms.push_back({match.captured(1), one.captured(1), length});
  }
  return uniforms;
}

/// Rewrites both shaders line by line of the fragment shader.
struct Mover {
  int vectorsLeft;
  QString fragment, declarations, assignments;
  QHash<QString, QStringList> lists;  ///< of declarations, by the names of their macros
  Lengths lengths;

  void add(const QString& line) {
    static const QRegularExpression number("^#define (\\w+) (\\d+)$");
    if (const auto match = number.match(line); match.hasMatch()) lengths[match.captured(1)] = match.captured(2).toInt();
    static const QRegularExpression list("^#define (\\w+)\\s+(uniform .*)$");
    if (const auto match = list.match(line); match.hasMatch()) {
      lists[match.captured(1)] = match.captured(2).split(';', Qt::SkipEmptyParts);
      return;
    }
    if (!lists.contains(line)) return addLine(line);
    for (const QString& one : lists[line])
      if (const QString trimmed = one.trimmed(); !trimmed.isEmpty()) addLine(trimmed + ';');
  }

  void addLine(const QString& line) {
    const std::vector<Uniform> uniforms = movableUniforms(line, lengths);
    int vectors = 0;
    for (const Uniform& uniform : uniforms) vectors += uniform.vectors();
    if (uniforms.empty() || vectors > vectorsLeft) return keep(line);
    vectorsLeft -= vectors;
    for (const Uniform& uniform : uniforms) move(uniform);
  }

  /// Conditions go into all three texts, so that each declares and assigns the same.
  void keep(const QString& line) {
    fragment += line + '\n';
    if (!line.startsWith('#') || line.startsWith("#version")) return;
    declarations += line + '\n';
    if (!line.startsWith("#define")) assignments += line + '\n';
  }

  void move(const Uniform& uniform) {
    const QString flat = "flat_" + uniform.name;
    fragment += QString("flat in %1;\n#define %2 %3\n").arg(uniform.declared(flat), uniform.name, flat);
    declarations += QString("uniform %1;\nflat out %2;\n").arg(uniform.declared(uniform.name), uniform.declared(flat));
    assignments += QString("%1 = %2;\n").arg(flat, uniform.name);
  }
};

}  // namespace

PassShaders withFlatUniforms(const PassShaders& shaders, int vectors) {
  Mover mover{vectors, {}, {}, {}, {}, {}};
  for (const QString& line : QString::fromUtf8(shaders.fragment).split('\n')) mover.add(line);
  const QString start = QStringLiteral("void main() {\n");
  QString vertex = QString::fromUtf8(shaders.vertex);
  vertex.replace(start, mover.declarations + start + mover.assignments);
  return {vertex.toUtf8(), mover.fragment.toUtf8()};
}

namespace {

bool link(QOpenGLShaderProgram& program, const PassShaders& shaders) {
  return program.addShaderFromSourceCode(QOpenGLShader::Vertex, shaders.vertex) &&
         program.addShaderFromSourceCode(QOpenGLShader::Fragment, shaders.fragment) && program.link();
}

/// Null where the driver refuses it.
std::unique_ptr<QOpenGLShaderProgram> linkedWithFlatUniforms(const PassShaders& shaders, int vectors) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  return link(*program, withFlatUniforms(shaders, vectors)) ? std::move(program) : nullptr;
}

/// Writes a shader for reading, if the environment asks for it (see ProgramCache).
void writeForReading(const QString& name, const QByteArray& shader) {
  const QString folder = qEnvironmentVariable("GONIO_SHADER_OUTPUT");
  if (folder.isEmpty()) return;
  QString path;
  for (int number = 1; path.isEmpty() || QFile::exists(path); ++number)
    path = QString("%1/%2-%3.frag").arg(folder, QFileInfo(name).completeBaseName()).arg(number);
  if (QFile file(path); !file.open(QIODevice::WriteOnly) || file.write(shader) != shader.size())
    qWarning("cannot write %s: %s", qPrintable(path), qPrintable(file.errorString()));
}

std::unique_ptr<QOpenGLShaderProgram> linked(const PassShaders& shaders, const QString& name) {
  auto program = std::make_unique<QOpenGLShaderProgram>();
  if (!link(*program, shaders))
    throw Error("shader " + name.toStdString() +
                " could not be compiled by the graphics driver: " + program->log().toStdString());
  return program;
}

}  // namespace

void ProgramCache::setFlatVectors(std::optional<int> vectors) {
  flatVectors_ = vectors;
  programs_.clear();
}

QOpenGLShaderProgram& ProgramCache::program(const QString& fragment, const QStringList& definitions,
                                            const QStringList& preamble) {
  const QString key = fragment + ' ' + definitions.join(' ');
  auto known = programs_.find(key);
  if (known == programs_.end()) {
    auto program = compiled(fragment, definitions, preamble);
    makeRoom();
    known = programs_.emplace(key, LinkedProgram{std::move(program)}).first;
  }
  known->second.lastUse = ++uses_;
  return *known->second.program;
}

void ProgramCache::drawFullscreen(QOpenGLFunctions_4_1_Core& gl) {
  if (!vertexArray_) gl.glGenVertexArrays(1, &vertexArray_);
  gl.glBindVertexArray(vertexArray_);
  gl.glDrawArrays(GL_TRIANGLES, 0, 3);
  gl.glBindVertexArray(0);
}

void ProgramCache::release(QOpenGLFunctions_4_1_Core& gl) {
  programs_.clear();
  gl.glDeleteVertexArrays(1, &vertexArray_);
  vertexArray_ = 0;
}

void ProgramCache::makeRoom() {
  if (programs_.size() < maxPrograms) return;
  programs_.erase(std::ranges::min_element(programs_, {}, [](const auto& entry) { return entry.second.lastUse; }));
}

std::unique_ptr<QOpenGLShaderProgram> ProgramCache::compiled(const QString& fragment, const QStringList& definitions,
                                                             const QStringList& preamble) const {
  if (compileListener_) compileListener_();
  const PassShaders shaders{assembleShader("preview/fullscreen.vert"), assembleShader(fragment, definitions, preamble)};
  writeForReading(fragment, shaders.fragment);
  if (flatVectors_)
    if (auto program = linkedWithFlatUniforms(shaders, *flatVectors_)) return program;
  return linked(shaders, fragment);
}

}  // namespace gonio::widgets

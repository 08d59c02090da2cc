// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/document/file_exports.h"

#include <QFileInfo>
#include <QImage>

#include "core/editing/blend_source.h"
#include "core/io/atomic_file.h"
#include "core/io/image_io.h"
#include "core/rendering/path_tracer.h"

namespace gonio::app {

namespace {

constexpr int exrSide = 1024, exrSamples = 128;

QString nameOf(const QString& path) { return path.section('/', -1); }

}  // namespace

FileExports::FileExports(Document& document, BackgroundTasks& tasks, QObject* parent)
    : QObject(parent), m_document(document), m_tasks(tasks) {}

bool FileExports::refuses(const QString& path) {
  if (!io::isOneOf(path.toStdString(), editing::sourceFiles(m_document.toEditDocument()))) return false;
  Q_EMIT failed(tr("Cannot write %1").arg(nameOf(path)),
                tr("%1 is a measured file that this document edits. Choose another name.").arg(path));
  return true;
}

template <class Result>
void FileExports::run(const QString& title, const QString& path, std::function<Result(const TaskControl&)> work,
                      std::function<void(const Result&)> done) {
  m_tasks.run<Result>(
      {.title = title.arg(nameOf(path)), .file = true}, std::move(work), std::move(done),
      [this, path](const QString& error) { Q_EMIT failed(tr("Cannot export %1").arg(nameOf(path)), error); },
      [this, path] { Q_EMIT cancelled(path); });
}

void FileExports::writeMaterial(const QString& path, exports::MaterialForm form) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || refuses(path)) return;
  run<ExportLosses>(
      tr("Exporting %1"), path,
      [material, base = m_document.base(), edits = m_document.edits(), form, path](const TaskControl& control) {
        return app::writeMaterial(*material, base, edits, form, path.toStdString(), control);
      },
      [this, path](const ExportLosses& losses) {
        Q_EMIT exported(path);
        if (!losses.sentences.isEmpty()) Q_EMIT warned(QStringLiteral("%1: %2").arg(nameOf(path), losses.text()));
      });
}

void FileExports::renderExr(const QString& path, const Scene& scene, const EffectOverrides& overrides,
                            const RenderMaterials& others) {
  const LoadedMaterialPtr material = m_document.material();
  if (!material || refuses(path)) return;
  const editing::EditList edits = m_document.edits();
  run<bool>(
      tr("Rendering %1"), path,
      [material, base = m_document.base(), edits, scene, overrides, others, path](const TaskControl& control) {
        const auto edited = std::make_shared<const RenderMaterial>(editing::applyEdits(base, edits));
        const RenderMaterials materials = bindMaterials(scene, materialsInSlots(scene, edited, others));
        constexpr std::uint64_t seed = 1;
        const PathTracer tracer(scene, materials, planEffects(scene, materials, overrides), seed);
        Film film(exrSide, exrSide);
        tracer.accumulate(film, exrSamples, control);
        io::writeExr(film.image(), path.toStdString(),
                     pictureAttributes(scene, tracer.plan(), material->material.name, film.samples, seed));
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); });
}

void FileExports::writePng(const QString& path, const QImage& picture) {
  if (refuses(path)) return;
  run<bool>(
      tr("Writing %1"), path,
      [picture, path](const TaskControl&) {
        const QImage rgba = picture.convertToFormat(QImage::Format_RGBA8888);
        std::vector<unsigned char> bytes;
        for (int y = 0; y < rgba.height(); ++y)
          bytes.insert(bytes.end(), rgba.constScanLine(y), rgba.constScanLine(y) + 4 * rgba.width());
        io::writePng(bytes, rgba.width(), rgba.height(), path.toStdString());
        return true;
      },
      [this, path](bool) { Q_EMIT exported(path); });
}

}  // namespace gonio::app

#include "moc_file_exports.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/file_menu.h"

#include <QApplication>
#include <QDockWidget>
#include <QFileDialog>
#include <QMenuBar>

#include "app/gonio/document/material_files.h"
#include "app/gonio/window/main_window.h"
#include "core/io/image_io.h"
#include "widgets/preview/preview_widget.h"

namespace gonio::app {

namespace {

/// With the suffix when the user left it out.
QString withSuffix(const QString& path, const QString& suffix) {
  return path.isEmpty() || path.endsWith(suffix, Qt::CaseInsensitive) ? path : path + suffix;
}

void savePng(MainWindow& window, const QString& path) {
  const QImage picture = window.preview().grabPicture().convertToFormat(QImage::Format_RGBA8888);
  std::vector<unsigned char> bytes;
  for (int y = 0; y < picture.height(); ++y)
    bytes.insert(bytes.end(), picture.constScanLine(y), picture.constScanLine(y) + 4 * picture.width());
  try {
    io::writePng(bytes, picture.width(), picture.height(), path.toStdString());
    Q_EMIT window.controller().exported(path);
  } catch (const Error& error) {
    Q_EMIT window.controller().failed(FileMenu::tr("Cannot export the picture"), QString::fromUtf8(error.what()));
  }
}

}  // namespace

FileMenu::FileMenu(MainWindow& window) : QObject(&window), m_window(window) {
  QMenu* menu = window.menuBar()->addMenu(tr("&File"));
  addOpening(menu);
  menu->addSeparator();
  addSaving(menu);
  menu->addSeparator();
  menu->addAction(tr("&Close Window"), QKeySequence::Close, &window, &QWidget::close);
  menu->addAction(tr("&Quit"), QKeySequence(Qt::CTRL | Qt::Key_Q), qApp, &QApplication::closeAllWindows);
}

void FileMenu::addOpening(QMenu* menu) {
  menu->addAction(tr("&New Window"), QKeySequence::New, this, [] { (new MainWindow)->show(); });
  menu->addAction(tr("&Open..."), QKeySequence::Open, this, &FileMenu::openFile);
  QMenu* recent = menu->addMenu(tr("Open &Recent"));
  const auto refill = [this, recent] { fillRecent(recent); };
  connect(menu, &QMenu::aboutToShow, this, refill);
  connect(&m_window.document(), &Document::titleChanged, this, refill);
  fillRecent(recent);
  menu->addSeparator();
  menu->addAction(tr("Open &Library Folder..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O), this,
                  &FileMenu::openFolder);
  menu->addAction(tr("&Bundled Library"), this, [this] { m_window.library().showBundled(); });
}

void FileMenu::addSaving(QMenu* menu) {
  QList<QAction*> needMaterial;
  needMaterial << menu->addAction(tr("&Save"), QKeySequence::Save, this, [this] { m_window.save(); });
  needMaterial << menu->addAction(tr("Save &As..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_S), this,
                                  [this] { m_window.saveAs(); });
  menu->addSeparator();
  needMaterial << menu->addAction(tr("&Export BRDF..."), QKeySequence(Qt::CTRL | Qt::Key_E), this,
                                  &FileMenu::exportBrdf);
  needMaterial << menu->addAction(tr("Export &Image..."), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E), this,
                                  &FileMenu::exportImage);
  const auto update = [this, needMaterial] {
    for (QAction* action : needMaterial) action->setEnabled(m_window.document().material() != nullptr);
  };
  connect(&m_window.document(), &Document::materialChanged, this, update);
  update();
}

void FileMenu::fillRecent(QMenu* menu) {
  menu->clear();
  for (const QString& path : m_window.recentFiles().paths()) {
    QAction* action = menu->addAction(path.section('/', -1), this, [this, path] { m_window.open(path); });
    action->setToolTip(path);
    action->setEnabled(RecentFiles::exists(path));
  }
  if (menu->isEmpty()) {
    menu->addAction(tr("Nothing opened yet"))->setEnabled(false);
    return;
  }
  menu->setToolTipsVisible(true);
  menu->addSeparator();
  menu->addAction(tr("&Clear"), this, [this] { m_window.recentFiles().clear(); });
}

void FileMenu::openFile() {
  const QString path = QFileDialog::getOpenFileName(&m_window, tr("Open"),
                                                    m_window.settings().value("folders/open").toString(), openFilter());
  if (path.isEmpty()) return;
  m_window.settings().setValue("folders/open", QFileInfo(path).absolutePath());
  m_window.open(path);
}

void FileMenu::openFolder() {
  const QString folder =
      QFileDialog::getExistingDirectory(&m_window, tr("Open Library Folder"), m_window.library().folder());
  if (folder.isEmpty()) return;
  m_window.library().showFolder(folder);
  m_window.docks().front()->show();
}

void FileMenu::exportBrdf() {
  const QString path =
      withSuffix(QFileDialog::getSaveFileName(&m_window, tr("Export BRDF"), m_window.document().name() + tableSuffix(),
                                              exportFilter()),
                 tableSuffix());
  if (!path.isEmpty()) m_window.controller().exportMerl(path);
}

void FileMenu::exportImage() {
  const QString path =
      QFileDialog::getSaveFileName(&m_window, tr("Export Image"), m_window.document().name() + ".png",
                                   tr("PNG, the preview as shown (*.png);;OpenEXR, rendered in linear light (*.exr)"));
  if (path.isEmpty()) return;
  if (path.endsWith(QStringLiteral(".exr"), Qt::CaseInsensitive))
    m_window.controller().exportExr(path, m_window.preview().scene(), m_window.preview().overrides(),
                                    m_window.preview().others());
  else
    savePng(m_window, withSuffix(path, QStringLiteral(".png")));
}

}  // namespace gonio::app

#include "moc_file_menu.cpp"

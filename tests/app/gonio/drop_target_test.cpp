// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/drop_target.h"

#include <QApplication>
#include <QDir>
#include <QDropEvent>
#include <QMimeData>
#include <QTest>
#include <QUrl>
#include <memory>

#include "tests/support/test_program.h"
#include "widgets/library/material_drag.h"
#include "widgets/panels/drop_overlay.h"

namespace drop_target_test {
using namespace gonio::app;

struct Target {
  QWidget window;
  QStringList opened;
  DropTarget target{window,
                    {[this](const QString& path) { opened << "material " + path; },
                     [this](const QString& path) { opened << "reference " + path; },
                     [this](const QString& path) { opened << "environment " + path; },
                     [this](const QString& path) { opened << "scene " + path; },
                     [this](const QString& path) { opened << "image " + path; },
                     [this](const QString& path) { opened << "folder " + path; },
                     [this](const QStringList& paths) { opened << "several " + paths.join(' '); }}};

  Target() { window.show(); }
  bool overlayIsShown() { return !window.findChild<gonio::widgets::DropOverlay*>()->isHidden(); }
  void drag(const QString& path) {
    const std::unique_ptr<QMimeData> data(gonio::widgets::toDrag(path));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, data.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
  }
  void dropFiles(const QStringList& paths) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window, &event);
  }
  void drop(const QString& path, Qt::KeyboardModifiers modifiers = {}) {
    drag(path);  // a drop goes where the drag entered last
    const std::unique_ptr<QMimeData> data(gonio::widgets::toDrag(path));
    QDropEvent event(QPointF(9, 9), Qt::CopyAction, data.get(), Qt::LeftButton, modifiers);
    QApplication::sendEvent(&window, &event);
  }
};

class DropTargetTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void eachKindOfFileHasItsAction() {
    Target target;
    target.drop("/a/chrome.binary");
    target.drop("/a/chrome.binary", Qt::ControlModifier);
    target.drop("/a/sky.HDR");
    target.drop("/a/bunny.obj", Qt::ControlModifier);
    target.drop("/a/sphere.JPG");
    target.drop("/a/light.exr");
    QCOMPARE(target.opened,
             (QStringList{"material /a/chrome.binary", "reference /a/chrome.binary", "environment /a/sky.HDR",
                          "scene /a/bunny.obj", "image /a/sphere.JPG", "environment /a/light.exr"}));
  }

  /// A folder becomes the folder of the library, and several materials are shown in it; other files among them do not
  /// count.
  void foldersAndSeveralFiles() {
    Target target;
    const QString folder = QDir::tempPath();
    target.drop(folder);
    target.dropFiles({"/a/one.binary", "/a/sky.hdr", "/a/two.bsdf"});
    target.dropFiles({"/a/one.binary", "/a/sky.hdr"});
    QCOMPARE(target.opened,
             (QStringList{"folder " + folder, "several /a/one.binary /a/two.bsdf", "material /a/one.binary"}));
  }

  /// A target for files of other programs leaves materials of the library alone.
  void otherProgramsOnly() {
    QWidget window;
    QStringList opened;
    DropTarget target(window, {[&](const QString& path) { opened << path; }, {}, {}, {}, {}},
                      DropTarget::Sources::otherPrograms);
    const std::unique_ptr<QMimeData> tile(gonio::widgets::toDrag("library:sgd/chrome"));
    QDragEnterEvent enter(QPoint(9, 9), Qt::CopyAction, tile.get(), Qt::LeftButton, {});
    QApplication::sendEvent(&window, &enter);
    QVERIFY(!enter.isAccepted());
  }

  void theOverlayIsShownWhileAFileIsDragged() {
    Target target;
    QVERIFY(!target.overlayIsShown());
    target.drag("/a/chrome.binary");
    QVERIFY(target.overlayIsShown());
    QDragLeaveEvent leave;
    QApplication::sendEvent(&target.window, &leave);
    QVERIFY(!target.overlayIsShown());
    target.drop("/a/chrome.binary");
    QVERIFY(!target.overlayIsShown());
  }
};

GONIO_TEST(DropTargetTest)
}  // namespace drop_target_test

#include "drop_target_test.moc"

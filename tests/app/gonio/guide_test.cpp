// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/help.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <QScrollBar>
#include <QTest>
#include <QTextBrowser>
#include <QTextCursor>
#include <set>

#include "tests/support/test_program.h"

namespace guide_test {
using namespace gonio::app;

/// The documentation in the source, with the laboratory notes, which are not built in.
const QString docs = QStringLiteral(GONIO_CODES_DIR) + "/../../docs/";

QString textOf(const QString& file) {
  QFile source(docs + file);
  return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

/// All pages, relative to docs.
QStringList allFiles() {
  QStringList files = QDir(docs).entryList({"*.md"}, QDir::Files);
  for (const QString& file : QDir(docs + "results").entryList({"*.md"}, QDir::Files)) files << "results/" + file;
  return files;
}

/// The anchors of a page: all its headings.
std::set<QString> anchorsOf(const QString& file) {
  std::set<QString> anchors;
  static const QRegularExpression heading(QStringLiteral("^#+ +(.*)$"), QRegularExpression::MultilineOption);
  for (auto it = heading.globalMatch(textOf(file)); it.hasNext();)
    anchors.insert(anchorOf(it.next().captured(1).remove('`')));
  return anchors;
}

class GuideTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  /// Every page has one title, which comes first; tutorials and how-to pages stand before the reference.
  void everyPageHasATitle() {
    const auto& pages = guidePages();
    QStringList files;
    for (const GuidePage& page : pages) {
      QVERIFY(!page.title.isEmpty());
      QCOMPARE(!files.contains(page.file), page.level == 1);
      if (page.level == 1) files << page.file;
    }
    QCOMPARE(files.front(), QString("getting-started.md"));
    const QString made = QStringLiteral("python-reference.md");  // by the build, where it finds Python
    QStringList expected = QDir(docs).entryList({"*.md"}, QDir::Files);
    if (QFile::exists(":/docs/" + made)) expected << made;
    QStringList sorted = files;
    sorted.sort();
    expected.sort();
    QCOMPARE(sorted, expected);
    for (const char* tutorial : {"tutorial-export.md", "tutorial-acquisition.md", "workflows.md"})
      QVERIFY(files.indexOf(tutorial) < files.indexOf("editor.md"));
    QVERIFY(files.indexOf("editor.md") < files.indexOf("formats.md"));
    QVERIFY(files.indexOf("formats.md") < files.indexOf("scenes.md") && !QFile::exists(":/docs/results"));
  }

  /// Links between the pages lead to pages and headings that are there.
  void everyLinkLeadsSomewhere() {
    static const QRegularExpression link(
        QStringLiteral("\\]\\(((?:\\.\\./|results/)?[a-z0-9-]+\\.md)?(?:#([^)]+))?\\)"));
    int count = 0;
    for (const QString& file : allFiles())
      for (auto it = link.globalMatch(textOf(file)); it.hasNext(); ++count) {
        const QRegularExpressionMatch match = it.next();
        const QString path = match.captured(1), anchor = match.captured(2);
        const QString folder = file.left(file.lastIndexOf('/') + 1);
        const QString target = path.isEmpty() ? file : QDir::cleanPath(folder + path);
        QVERIFY2(QFile::exists(docs + target), qPrintable(file + " links to " + target));
        QVERIFY2(anchor.isEmpty() || anchorsOf(target).contains(anchor),
                 qPrintable(file + " links to " + target + '#' + anchor));
      }
    QVERIFY(count > 20);
  }

  /// A heading is scrolled to, links are followed to pages and places, and one that leads nowhere changes nothing.
  void pagesAndHeadings() {
    GuideWindow guide(nullptr);
    guide.show();
    guide.showPage("editor.md", "Export Image");
    const int there = guide.text().verticalScrollBar()->value();
    QVERIFY(there > 0);
    guide.showPage("editor.md");
    QCOMPARE(guide.text().verticalScrollBar()->value(), 0);
    Q_EMIT guide.text().anchorClicked(QUrl("formats.md#spectral-rgl-files"));
    QCOMPARE(guide.page(), QString("formats.md"));
    QVERIFY(guide.text().verticalScrollBar()->value() > 0);
    Q_EMIT guide.text().anchorClicked(QUrl("images/none.png"));
    QCOMPARE(guide.page(), QString("formats.md"));
    QVERIFY(!guide.text().toPlainText().contains("SPDX"));
    // Laboratory notes are named, and no link leads to one.
    guide.showPage("edits.md");
    QVERIFY(guide.text().toPlainText().contains("Compositions [docs/results/compositions.md] compares"));
    QVERIFY(!guide.text().toHtml().contains("href=\"results/"));
    guide.showPage("exports.md");
    QVERIFY(guide.text().toPlainText().contains("targets is in docs/results/exports.md."));
    Q_EMIT guide.text().anchorClicked(QUrl("results/dictionaries.md"));
    QCOMPARE(guide.page(), QString("exports.md"));
    // Pictures leave no placeholder.
    guide.showPage("tutorial-compare.md");
    QVERIFY(!guide.text().toPlainText().contains(QChar::ObjectReplacementCharacter));
  }

  /// By the mouse, whose event the old page still handles while the new one is shown.
  void clickedLinks() {
    GuideWindow guide(nullptr);
    guide.show();
    for (int n = 0; n < 3; ++n) {
      guide.showPage("editor.md");
      QTextBrowser& text = guide.text();
      QTextCursor cursor(text.document());
      const auto leads = [&] { return cursor.charFormat().anchorHref().contains(".md"); };
      while (!leads() && cursor.movePosition(QTextCursor::NextCharacter)) continue;
      QVERIFY(leads());
      text.setTextCursor(cursor);
      text.ensureCursorVisible();
      QTest::mouseClick(text.viewport(), Qt::LeftButton, {}, text.cursorRect(cursor).center() - QPoint(2, 0));
      QVERIFY(guide.page() != "editor.md");
    }
  }

  void anchors() { QCOMPARE(anchorOf("Render MATERIAL (a scene), as-is!"), QString("render-material-a-scene-as-is")); }
};

GONIO_TEST(GuideTest)

}  // namespace guide_test

#include "guide_test.moc"

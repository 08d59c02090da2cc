// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/guide.h"

#include <QAbstractTextDocumentLayout>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QListWidget>
#include <QPointer>
#include <QRegularExpression>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocument>
#include <QVBoxLayout>

namespace gonio::app {

namespace {

const QString root = QStringLiteral(":/docs/"), firstPage = QStringLiteral("editor.md"),
              resultsFolder = QStringLiteral("results/");
constexpr int lastListedLevel = 2;

QString read(const QString& file) {
  QFile source(root + file);
  return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

std::vector<GuidePage> headingsOf(const QString& file) {
  std::vector<GuidePage> pages;
  bool isCode = false;
  for (const QString& line : read(file).split('\n')) {
    if (line.startsWith(QLatin1String("```"))) isCode = !isCode;
    int level = 0;
    while (level < line.size() && line[level] == '#') ++level;
    if (isCode || level == 0 || level > lastListedLevel) continue;
    pages.push_back({file, line.mid(level).remove('`').trimmed(), level});
  }
  return pages;
}

}  // namespace

const std::vector<GuidePage>& guidePages() {
  static const std::vector<GuidePage> pages = [] {
    QStringList files = QDir(root).entryList(QDir::Files, QDir::Name);
    files.removeAll(firstPage);
    files.prepend(firstPage);
    for (const QString& file : QDir(root + resultsFolder).entryList(QDir::Files, QDir::Name))
      files << resultsFolder + file;
    std::vector<GuidePage> all;
    for (const QString& file : files)
      for (const GuidePage& page : headingsOf(file)) all.push_back(page);
    return all;
  }();
  return pages;
}

QString linkedPage(const QString& file, const QString& path) {
  return path.isEmpty() ? file : QDir::cleanPath(file.left(file.lastIndexOf('/') + 1) + path);
}

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber() || c == '-' || c == '_')
      anchor += c;
    else if (c == ' ')
      anchor += '-';
  return anchor;
}

GuideWindow::GuideWindow(QWidget* parent) : QDialog(parent), m_pages(new QListWidget), m_text(new QTextBrowser) {
  setWindowTitle(tr("Guide"));
  const int em = fontMetrics().height();
  resize(em * 60, em * 44);
  for (const GuidePage& page : guidePages())
    if (page.level == 1) {
      auto* item = new QListWidgetItem(page.title, m_pages);
      item->setData(Qt::UserRole, page.file);
    }
  m_pages->setAccessibleName(tr("Pages"));
  m_pages->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_text->setOpenLinks(false);
  auto* split = new QSplitter;
  split->addWidget(m_pages);
  split->addWidget(m_text);
  split->setStretchFactor(1, 1);
  split->setSizes({em * 15, em * 45});
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(split);
  connect(m_pages, &QListWidget::currentItemChanged, this, [this](const QListWidgetItem* item) {
    if (item && item->data(Qt::UserRole).toString() != m_file) showPage(item->data(Qt::UserRole).toString());
  });
  connect(m_text, &QTextBrowser::anchorClicked, this, &GuideWindow::follow);
}

void GuideWindow::showPage(const QString& file, const QString& heading) {
  if (file != m_file) {
    m_file = file;
    // Comments are for the source, and pictures are not built in.
    static const QRegularExpression leftOut(QStringLiteral("<!--.*?-->|!\\[[^\\]]*\\]\\([^)]*\\)"));
    setMarkdown(read(file).remove(leftOut));
    for (int row = 0; row < m_pages->count(); ++row)
      if (m_pages->item(row)->data(Qt::UserRole) == file) m_pages->setCurrentRow(row);
  }
  if (heading.isEmpty()) return m_text->verticalScrollBar()->setValue(0);
  scrollTo([&](const QString& text) { return text == heading; });
}

/// A document that is shown already is laid out anew after each inserted word: 8 s for a page with long tables.
void GuideWindow::setMarkdown(const QString& text) {
  auto* document = new QTextDocument(m_text);
  document->setDefaultFont(m_text->font());
  document->setDocumentMargin(fontMetrics().height());
  document->setMarkdown(text);
  const QPointer<QTextDocument> before = m_text->document();  // the browser deletes the first one
  m_text->setDocument(document);
  if (before) before->deleteLater();  // it may hold the link that was clicked
}

void GuideWindow::scrollTo(const std::function<bool(const QString&)>& fits) {
  for (QTextBlock block = m_text->document()->begin(); block.isValid(); block = block.next()) {
    if (block.blockFormat().headingLevel() == 0 || !fits(block.text())) continue;
    const QRectF place = m_text->document()->documentLayout()->blockBoundingRect(block);
    return m_text->verticalScrollBar()->setValue(int(place.top()));
  }
}

void GuideWindow::follow(const QUrl& link) {
  const QString file = linkedPage(m_file, link.path());
  if (!link.isRelative()) {
    QDesktopServices::openUrl(link);
    return;
  }
  if (!QFile::exists(root + file)) return;  // a picture, or a page that is not built in
  showPage(file);
  if (const QString anchor = link.fragment(); !anchor.isEmpty())
    scrollTo([&](const QString& text) { return anchorOf(text) == anchor; });
}

void openGuide(QWidget* window, const QString& file, const QString& heading) {
  auto* guide = window->findChild<GuideWindow*>();
  if (!guide) {
    guide = new GuideWindow(window);
    guide->setAttribute(Qt::WA_DeleteOnClose);
  }
  guide->show();
  guide->raise();
  guide->showPage(file, heading);
}

}  // namespace gonio::app

#include "moc_guide.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/window/help.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDialog>
#include <QDialogButtonBox>
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

#include "app/gonio/window/action_table.h"
#include "core/editing/differential_edit.h"
#include "core/models/model.h"
#include "widgets/parameters/formula_text.h"
#include "widgets/parameters/parameter_text.h"

namespace gonio::app {

namespace {

const QString root = QStringLiteral(":/docs/"), firstPage = QStringLiteral("getting-started.md"),
              indexPage = QStringLiteral("index.md");
constexpr int lastListedLevel = 2;

QString read(const QString& file) {
  QFile source(root + file);
  return source.open(QIODevice::ReadOnly) ? QString::fromUtf8(source.readAll()) : QString();
}

/// The text of a page without comments, which are for the source, and pictures, which are not built in. The laboratory
/// notes are not built in either: a link to one becomes its place in the source repository.
QString shownText(const QString& file) {
  static const QRegularExpression leftOut(QStringLiteral("<!--.*?-->|!\\[[^\\]]*\\]\\([^)]*\\)"));
  static const QString target = QStringLiteral("\\((results/[^)#]*)(?:#[^)]*)?\\)");
  static const QRegularExpression path(QStringLiteral("\\[results/[^\\]]*\\]") + target),
      name(QStringLiteral("\\[([^\\]]*)\\]") + target);
  return read(file)
      .remove(leftOut)
      .replace(path, QStringLiteral("docs/\\1"))
      .replace(name, QStringLiteral("\\1 [docs/\\2]"));
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

/// In the order in which the lists of the index name them: tutorials, how-to pages, reference, background.
QStringList pageFiles() {
  static const QRegularExpression name(QStringLiteral("[a-z0-9-]+\\.md"));
  QStringList files{firstPage, indexPage};
  for (const QString& line : read(indexPage).split('\n'))
    if (line.startsWith(QLatin1String("- ")))
      for (auto it = name.globalMatch(line); it.hasNext();) files << it.next().captured();
  files += QDir(root).entryList(QDir::Files, QDir::Name);
  files.removeDuplicates();
  files.removeIf([](const QString& file) { return !QFile::exists(root + file); });
  return files;
}

}  // namespace

const std::vector<GuidePage>& guidePages() {
  static const std::vector<GuidePage> pages = [] {
    std::vector<GuidePage> all;
    for (const QString& file : pageFiles())
      for (const GuidePage& page : headingsOf(file)) all.push_back(page);
    return all;
  }();
  return pages;
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
    setMarkdown(shownText(file));
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
  const QString file = link.path().isEmpty() ? m_file : link.path();
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

namespace {

struct HelpPagesText {
  Q_DECLARE_TR_FUNCTIONS(HelpPages)
};
QString escaped(std::string_view text) { return widgets::toQString(text).toHtmlEscaped(); }

QString row(const QString& left, const QString& right) {
  return QStringLiteral("<tr><td style='padding: 2px 24px 2px 0'>%1</td><td style='padding: 2px 0'>%2</td></tr>")
      .arg(left, right);
}

/// What the mouse and single widgets do: nothing that an action shows.
QString gestures() {
  return row(HelpPagesText::tr("Drag in the preview"), HelpPagesText::tr("orbit (distant light: move the light)")) +
         row(HelpPagesText::tr("Right drag in the preview"), HelpPagesText::tr("orbit; a right click opens the menu")) +
         row(HelpPagesText::tr("Middle drag, Shift + drag in the preview"), HelpPagesText::tr("pan")) +
         row(HelpPagesText::tr("Wheel in the preview"), HelpPagesText::tr("zoom to the pointer")) +
         row(HelpPagesText::tr("Shift + right drag in the preview"), HelpPagesText::tr("rotate the environment")) +
         row(HelpPagesText::tr("Alt + drag in the preview"),
             HelpPagesText::tr("edit the highlight: outwards widens it, upwards strengthens it")) +
         row(HelpPagesText::tr("F, R in the preview"), HelpPagesText::tr("frame the object, reset the view")) +
         row(HelpPagesText::tr("Shift, Ctrl while dragging a slider"), HelpPagesText::tr("fine steps, snap")) +
         row(HelpPagesText::tr("Double-click on a label or slider"), HelpPagesText::tr("reset the parameter")) +
         row(HelpPagesText::tr("Arrow keys, Page Up, Page Down"), HelpPagesText::tr("step a slider or a number")) +
         row(HelpPagesText::tr("Typing into a number"), HelpPagesText::tr("arithmetic works: 0.3*2")) +
         row(HelpPagesText::tr("Drag a point of a factor curve, Escape"),
             HelpPagesText::tr("move the selected points, cancel the drag")) +
         row(HelpPagesText::tr("Enter in the library"), HelpPagesText::tr("open the material")) +
         row(HelpPagesText::tr("Ctrl + Enter, Shift + Enter in the library"),
             HelpPagesText::tr("compare, blend with the material")) +
         row(HelpPagesText::tr("Arrow keys, 1 to 4 in the Blend panel"),
             HelpPagesText::tr("move the point, go to a corner"));
}

QString formulaLine(const QString& text) { return QStringLiteral("<p><tt>%1</tt></p>").arg(text); }

QString editFormulae() {
  QString page =
      QStringLiteral("<h3>%1</h3><p>%2</p>%3<p>%4</p>")
          .arg(
              HelpPagesText::tr("Edits of a model"),
              HelpPagesText::tr("An edit changes the parameters of a model from their fitted to their edited values. "
                                "It applies this change to the measurement:"),
              formulaLine(HelpPagesText::tr("edited = max(0, m + strength (composition − m))")),
              HelpPagesText::tr("m is the measurement, M the fitted model and M′ the edited model. The compositions:"));
  for (const editing::CompositionRecord& record : editing::compositionRecords) {
    page += QStringLiteral("<p><b>%1</b>: %2</p>").arg(escaped(record.name), escaped(record.description)) +
            formulaLine(widgets::formulaHtml(record.formula).replace('\n', QStringLiteral("<br>")));
    if (!record.reference.empty()) page += QStringLiteral("<p><i>%1</i></p>").arg(escaped(record.reference));
  }
  return page;
}

/// The model under the Factor curves dock (core/factorization/pdv_factors.h).
QString factorFormulae() {
  return QStringLiteral("<h3>%1</h3><p>%2</p>%3<p>%4</p>%5<p>%6</p>%7<p>%8</p>%9<p><i>%10</i></p>")
      .arg(HelpPagesText::tr("Factor curves (projected deviation)"),
           HelpPagesText::tr("In each colour channel the transformed BRDF value is a sum of products of curves. θR is "
                             "the angle of the mirror direction R, Δp the vector from R to the light on the unit disk, "
                             "φ its azimuth; the form with two curves has no F3."),
           formulaLine(HelpPagesText::tr("y = ln(1 + ρ) = Σ F1(θR) F2(|Δp|) F3(|φ|)")),
           HelpPagesText::tr("With \"Preserve measured detail\":"),
           formulaLine(
               HelpPagesText::tr("edited = max(0, measured + strength (ρ(edited curves) − ρ(original curves)))")),
           HelpPagesText::tr("Without \"Preserve measured detail\":"),
           formulaLine(HelpPagesText::tr("edited = (1 − strength) measured + strength ρ(edited curves)")),
           HelpPagesText::tr("Distances from the mirror direction to the nearest and the farthest point of the horizon "
                             "(the edge of the unit disk):"),
           formulaLine(HelpPagesText::tr("|Δp| = 1 − sin θR, |Δp| = 1 + sin θR")))
      .arg(HelpPagesText::tr(
          "Tongbuasirilai, Unger, Kronander and Kurt, Compact and intuitive data-driven BRDF models, 2019"));
}

}  // namespace

QString shortcutsPage(const QList<NamedAction>& actions) {
  QString table;
  for (const NamedAction& named : actions) {
    QStringList keys;
    for (const QKeySequence& key : named.action->shortcuts())
      keys << key.toString(QKeySequence::NativeText).toHtmlEscaped();
    if (!keys.isEmpty())
      table += row(named.path.toHtmlEscaped(), QStringLiteral("<b>%1</b>").arg(keys.join(HelpPagesText::tr(" or "))));
  }
  return QStringLiteral("<h2>%1</h2><table>%2</table><h3>%3</h3><table>%4</table>")
      .arg(HelpPagesText::tr("Shortcuts"), table, HelpPagesText::tr("Mouse and keys"), gestures());
}

QString formulaePage() {
  QString page = QStringLiteral("<h2>%1</h2><p>%2</p>")
                     .arg(HelpPagesText::tr("Formulae"),
                          HelpPagesText::tr("Directions point away from the surface; the normal is z. Values are "
                                            "linear RGB in 1/sr, without the cosine."));
  page += editFormulae() + factorFormulae();
  for (const models::Model* model : models::allModels()) {
    const models::ModelSpec& spec = model->spec();
    page += QStringLiteral("<h3>%1</h3><p>%2</p><p>%3</p><p><i>%4</i></p><table>")
                .arg(escaped(spec.name), escaped(spec.description), widgets::formulaHtml(spec.formula),
                     escaped(spec.reference));
    for (const models::ParameterSpec& parameter : spec.parameters)
      page += row(QStringLiteral("<b>%1</b> %2").arg(escaped(parameter.label), widgets::formulaHtml(parameter.symbol)),
                  QStringLiteral("%1<br>%2<br><i>%3</i>")
                      .arg(escaped(parameter.description), widgets::formulaHtml(parameter.formula),
                           escaped(parameter.reference)));
    page += QStringLiteral("</table>");
  }
  return page;
}

QString aboutPage() {
  QString page = QStringLiteral("<h2>Gonio %1</h2><p>%2</p><h3>%3</h3><p>%4</p><p>%5</p><h3>%6</h3><table>")
                     .arg(QStringLiteral(GONIO_VERSION), HelpPagesText::tr("An editor for measured materials (BRDFs)."),
                          HelpPagesText::tr("Licences"),
                          HelpPagesText::tr("The modelling library (core) and goniotool: Apache-2.0."),
                          HelpPagesText::tr("This editor: GPL-3.0-or-later. It comes with no warranty."),
                          HelpPagesText::tr("Third-party software"));
  const std::pair<const char*, const char*> parties[] = {{"Qt 6", "LGPL-3.0-only"},
                                                         {"Eigen", "MPL-2.0"},
                                                         {"GLM", "MIT"},
                                                         {"OpenEXR", "BSD-3-Clause"},
                                                         {"oneTBB", "Apache-2.0"},
                                                         {"Ceres Solver", "BSD-3-Clause"},
                                                         {"nlohmann/json", "MIT"},
                                                         {"OpenSSL", "Apache-2.0"},
                                                         {"stb", "MIT or public domain"},
                                                         {"Embree", "Apache-2.0"},
                                                         {"cairo", "LGPL-2.1-only or MPL-1.1"},
                                                         {"Imath", "BSD-3-Clause"},
                                                         {"jemalloc", "BSD-2-Clause"},
                                                         {"QCustomPlot", "GPL-3.0-or-later"}};
  for (const auto& [name, licence] : parties) page += row(QString::fromLatin1(name), QString::fromLatin1(licence));
  page +=
      QStringLiteral("</table><h3>%1</h3><p>%2</p>")
          .arg(HelpPagesText::tr("Data"),
               HelpPagesText::tr(
                   "The bundled library contains measured materials of the RGL database (Dupuy and Jakob, An Adaptive "
                   "Parameterization for Efficient Material Acquisition and Rendering, 2018; CC0), near-measured "
                   "copies of MERL, RGL and DTU materials (Sztrajman, Rainer, Ritschel and Weyrich, Neural BRDF "
                   "Representation and Importance Sampling, 2021; MIT) and published SGD fits of the MERL "
                   "materials (Bagher, Soler and Holzschuch, Accurate fitting of measured reflectances using a "
                   "Shifted Gamma micro-facet distribution, 2012). The fits and most of the copies represent "
                   "materials of the MERL database (Matusik, Pfister, Brand and McMillan, A Data-Driven Reflectance "
                   "Model, 2003), which is not included. The bundled dictionary was learned from the near-measured "
                   "copies. The scenes and environments were made for Gonio."));
  return page;
}

void showPage(const QString& title, const QString& html, QWidget* parent) {
  auto* dialog = new QDialog(parent);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(title);
  auto* text = new QTextBrowser(dialog);
  text->setHtml(html);
  text->setFrameShape(QFrame::NoFrame);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::reject);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(text);
  layout->addWidget(buttons);
  const int em = dialog->fontMetrics().height();
  dialog->resize(em * 42, em * 38);
  dialog->show();
}

}  // namespace gonio::app

#include "moc_help.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "widgets/plots/plot.h"

#include <QBuffer>
#include <QContextMenuEvent>
#include <QImage>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPainter>
#include <QSvgGenerator>
#include <algorithm>
#include <filesystem>

#include "core/io/atomic_file.h"
#include "core/io/csv_text.h"
#include "core/support/error.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/plots/plot_series.h"

namespace gonio::widgets {

namespace {
namespace fs = std::filesystem;
constexpr double pngScale = 2;
constexpr QSize smallest(480, 320);
QSize exportSize(const Plot& plot, const QSize& size) {
  return size.isEmpty() ? plot.size().expandedTo(smallest) : size;
}
}  // namespace

QByteArray plotAsSvg(Plot& plot, const QSize& wanted) {
  const QSize size = exportSize(plot, wanted);
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setSize(size);
  generator.setViewBox(QRect(QPoint(0, 0), size));
  generator.setResolution(plot.logicalDpiX());
  generator.setTitle(plot.title());
  generator.setDescription(plot.source());
  plot.drawOn(generator, size, PlotStyle::paper());
  return buffer.data();
}

QByteArray plotAsPng(Plot& plot, const QSize& wanted) {
  const QSize size = exportSize(plot, wanted);
  QImage image(size * pngScale, QImage::Format_RGB32);
  image.setDevicePixelRatio(pngScale);
  image.fill(Qt::white);
  plot.drawOn(image, size, PlotStyle::paper());
  QBuffer buffer;
  image.save(&buffer, "PNG");
  return buffer.data();
}

QByteArray plotAsCsv(const Plot& plot) { return QByteArray::fromStdString(io::toCsv(plot.table())); }

void exportPlot(Plot& plot, const QString& path, const QSize& size) {
  QByteArray content;
  if (path.endsWith(QStringLiteral(".svg"), Qt::CaseInsensitive))
    content = plotAsSvg(plot, size);
  else if (path.endsWith(QStringLiteral(".png"), Qt::CaseInsensitive))
    content = plotAsPng(plot, size);
  else if (path.endsWith(QStringLiteral(".csv"), Qt::CaseInsensitive))
    content = plotAsCsv(plot);
  else
    throw Error(path.toStdString() + ": found the suffix '" + fs::path(path.toStdString()).extension().string() +
                "', expected .svg, .png or .csv");
  io::writeFileAtomically(path.toStdString(), content.toStdString());
}

namespace {
constexpr double keyStep = radians(1);
const QString dialogPurpose = QStringLiteral("plot");
}  // namespace

Plot::Plot(const QString& title, QWidget* parent)
    : QWidget(parent), m_title(title), m_readout(new QLabel(this)), m_hint(new QLabel(this)) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAccessibleName(title);
  for (QLabel* label : {m_readout, m_hint}) {
    label->setTextFormat(Qt::PlainText);
    label->setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  m_readout->setMargin(fontMetrics().height() / 4);
  m_readout->setAutoFillBackground(true);
  m_readout->setBackgroundRole(QPalette::ToolTipBase);
  m_readout->setForegroundRole(QPalette::ToolTipText);
  m_readout->hide();
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setForegroundRole(QPalette::PlaceholderText);
}

QSize Plot::sizeHint() const { return QSize(40, 20) * fontMetrics().height(); }
QSize Plot::minimumSizeHint() const { return QSize(14, 8) * fontMetrics().height(); }

void Plot::setSettings(const PlotSettings& settings) {
  if (settings == m_settings) return;
  m_settings = settings;
  refresh();
}

void Plot::setHint(const QString& hint) {
  m_hint->setText(hint);
  showEmptiness();
}

void Plot::showEmptiness() {
  m_hint->setVisible(isEmpty());
  m_hint->raise();
  if (isEmpty()) m_readout->hide();
}

std::vector<std::string> Plot::commentsOfTable() const {
  return {"Gonio plot: " + m_title.toStdString(), "material: " + m_source.toStdString(), conventionForCsv()};
}

void Plot::showReadout(const QString& text, const QPointF& pointer) {
  m_readout->setVisible(!text.isEmpty() && !isEmpty());
  if (text.isEmpty()) return;
  m_readout->setText(text);
  m_readout->adjustSize();
  m_readout->raise();
  // Right of the pointer and above it, or where there is room.
  const int away = fontMetrics().height();
  const QPoint at = pointer.toPoint();
  const bool left = at.x() + away + m_readout->width() > width();
  m_readout->move(left ? std::max(0, at.x() - away - m_readout->width()) : at.x() + away,
                  std::clamp(at.y() - m_readout->height() - away / 2, 0, std::max(0, height() - m_readout->height())));
}

void Plot::editThetaI(double thetaI) { Q_EMIT thetaIEdited(std::clamp(thetaI, 0.0, maxThetaI)); }

void Plot::exportAs(const QString& suffix, const QSize& size) {
  const QString name =
      QStringLiteral("%1 %2.%3").arg(m_source, m_title.toLower(), suffix).simplified().replace('/', '-');
  const QString filter = tr("%1 file (*.%2)").arg(suffix.toUpper(), suffix);
  askForPath(this, tr("Export Plot"), inDialogFolder(dialogPurpose, name), filter, [this, size](const QString& path) {
    rememberDialogFolder(dialogPurpose, path);
    try {
      exportPlot(*this, path, size);
      Q_EMIT exported(path);
    } catch (const Error& error) {
      Q_EMIT failed(tr("Cannot export the plot"), QString::fromUtf8(error.what()));
    }
  });
}

void Plot::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("&Reset View"), this, &Plot::resetView)->setShortcut(Qt::Key_Home);
  menu->addSeparator();
  const std::pair<QString, const char*> formats[] = {
      {tr("Export as &SVG..."), "svg"}, {tr("Export as &PNG..."), "png"}, {tr("Export as &CSV..."), "csv"}};
  for (const auto& [text, suffix] : formats)
    menu->addAction(text, this, [this, suffix = suffix] { exportAs(QLatin1String(suffix)); })->setEnabled(!isEmpty());
  menu->popup(event->globalPos());
}

void Plot::keyPressEvent(QKeyEvent* event) {
  const double step = event->modifiers() & Qt::ShiftModifier ? keyStep / 10 : keyStep;
  switch (event->key()) {
    case Qt::Key_Left:
      return editThetaI(m_settings.thetaI - step);
    case Qt::Key_Right:
      return editThetaI(m_settings.thetaI + step);
    case Qt::Key_Home:
      return resetView();
    default:
      QWidget::keyPressEvent(event);
  }
}

void Plot::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) refresh();
}

void Plot::resizeEvent(QResizeEvent*) { m_hint->setGeometry(rect().adjusted(20, 20, -20, -20)); }

void Plot::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), style().background); }

void Plot::leaveEvent(QEvent*) { showReadout({}); }

}  // namespace gonio::widgets

#include "moc_plot.cpp"

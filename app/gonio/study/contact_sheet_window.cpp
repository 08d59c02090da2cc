// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/contact_sheet_window.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPointer>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>

#include "app/gonio/library/thumbnail.h"
#include "core/rendering/error_maps.h"
#include "widgets/inputs/dialogs.h"
#include "widgets/inputs/menu_text.h"

namespace gonio::app {

namespace {

const QString pictureFolder = QStringLiteral("plot");
constexpr int side = 256, samples = 32, firstCount = 8, minTile = 96, maxTile = 384, firstTile = 160;
constexpr int savedTile = 320, savedColumns = 6;

QImage imageOf(const std::vector<std::uint8_t>& rgba) {
  return QImage(rgba.data(), side, side, 4 * side, QImage::Format_RGBA8888).copy();
}

/// Tile 0 is the material.
widgets::PreviewSubject subjectOf(const SheetSource& source, int tile, const TaskControl& control) {
  if (tile == 0) return widgets::measuredSubject(source.material->base, source.material->density);
  return source.entries[std::size_t(tile - 1)].subject(control);
}

SheetSource bestFirst(SheetSource source) {
  std::ranges::stable_sort(source.entries, std::greater(), [](const SheetEntry& entry) {
    return std::isnan(entry.snr) ? -std::numeric_limits<double>::infinity() : entry.snr;
  });
  return source;
}

}  // namespace

ContactSheetWindow::ContactSheetWindow(BackgroundTasks& tasks, SheetSource source, QWidget* parent)
    : QDialog(parent), m_tasks(tasks), m_source(bestFirst(std::move(source))), m_sheet(new widgets::ContactSheet) {
  // Several sheets may be open.
  const QString key = QStringLiteral("contact-sheet %1 ").arg(quintptr(this));
  m_renderKey = key + "pictures";
  m_mapsKey = key + "maps";
  m_pairKey = key + "pair";
  setWindowTitle(tr("Contact Sheet: %1").arg(widgets::titleText(m_source.name)));
  m_tiles.push_back({m_source.name, sourceKind(*m_source.material), {}, {}});
  for (const SheetEntry& entry : m_source.entries) m_tiles.push_back({entry.name, entry.numbers, {}, {}});
  build();
  showTiles();
  start();
}

ContactSheetWindow::~ContactSheetWindow() {
  for (const QString& key : {m_renderKey, m_mapsKey, m_pairKey}) m_tasks.drop(key);
}

void ContactSheetWindow::build() {
  const int em = fontMetrics().height();
  resize(em * 58, em * 40);
  m_count = new QSpinBox;
  m_count->setRange(1, std::max(1, int(m_source.entries.size())));
  m_count->setValue(firstCount);
  m_maps = new QCheckBox(tr("Error &maps"));
  m_maps->setChecked(true);
  m_maps->setToolTip(tr("Shows the absolute luminance difference from the material, on one scale for all images"));
  auto* size = new QSlider(Qt::Horizontal);
  size->setRange(minTile, maxTile);
  size->setValue(firstTile);
  size->setFixedWidth(8 * em);
  size->setAccessibleName(tr("Image size"));
  size->setToolTip(size->accessibleName());
  m_compare = new QPushButton(tr("&Compare in the Preview"));
  m_compare->setToolTip(tr("Select two images by clicking, or with the arrow keys and Space"));
  m_save = new QPushButton(tr("&Save Image..."));
  auto* label = new QLabel(tr("Show &best"));
  label->setBuddy(m_count);
  auto* top = new QHBoxLayout;
  top->addWidget(label);
  top->addWidget(m_count);
  top->addWidget(m_maps);
  top->addWidget(size);
  top->addStretch();
  for (QPushButton* button : {m_compare, m_save}) {
    button->setAutoDefault(false);
    top->addWidget(button);
  }
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_sheet);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusProxy(m_sheet);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(scroll, 1);
  connect(m_count, &QSpinBox::valueChanged, this, [this] {
    m_complete = false;
    showTiles();
    if (m_comparison && !m_tasks.isRunning(m_renderKey)) renderNext();
  });
  connect(m_maps, &QCheckBox::toggled, m_sheet, &widgets::ContactSheet::setMapsShown);
  connect(size, &QSlider::valueChanged, m_sheet, &widgets::ContactSheet::setTileSide);
  connect(m_compare, &QPushButton::clicked, this, &ContactSheetWindow::compareSelected);
  connect(m_save, &QPushButton::clicked, this, &ContactSheetWindow::save);
  const auto update = [this] { m_compare->setEnabled(m_sheet->selected().size() == 2); };
  connect(m_sheet, &widgets::ContactSheet::selectionChanged, this, update);
  update();
}

void ContactSheetWindow::setCount(int count) { m_count->setValue(count); }

std::size_t ContactSheetWindow::shownCount() const {
  return std::min(m_source.entries.size(), std::size_t(m_count->value()));
}

void ContactSheetWindow::start() {
  m_tasks.run<std::shared_ptr<const RenderedComparison>>(
      {tr("Rendering the contact sheet"), m_renderKey},
      [material = m_source.material](const TaskControl& control) {
        const RenderOptions options{.width = side, .height = side, .samples = samples, .density = {}};
        return std::make_shared<const RenderedComparison>(*material->material.brdf, options, control);
      },
      [this](const std::shared_ptr<const RenderedComparison>& comparison) {
        m_comparison = comparison;
        m_tiles[0].picture = QPixmap::fromImage(displayedImage(comparison->reference()));
        renderNext();
      },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot render the contact sheet"), error); });
}

void ContactSheetWindow::renderNext() {
  showTiles();
  const std::size_t next = m_pictures.size();
  if (next >= shownCount()) return makeMaps();
  m_tasks.run<Image>(
      {tr("Rendering %1").arg(m_source.entries[next].name), m_renderKey},
      [comparison = m_comparison, brdf = m_source.entries[next].brdf](const TaskControl& control) {
        return comparison->render(*brdf, control).image;
      },
      [this, next](const Image& picture) {
        m_tiles[next + 1].picture = QPixmap::fromImage(displayedImage(picture));
        m_pictures.push_back(picture);
        renderNext();
      },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot render the contact sheet"), error); });
}

void ContactSheetWindow::makeMaps() {
  const std::size_t count = shownCount();
  m_complete = false;
  if (m_pictures.size() < count) return;
  struct Made {
    std::vector<QImage> maps;
    double range;
  };
  m_tasks.run<Made>(
      {.title = tr("Comparing the images"), .key = m_mapsKey, .live = true},
      [comparison = m_comparison,
       pictures = std::vector(m_pictures.begin(), m_pictures.begin() + std::ptrdiff_t(count))](const TaskControl&) {
        const ErrorMaps maps = errorMaps(comparison->reference(), pictures);
        Made made{.range = maps.range};
        for (const auto& map : maps.maps) made.maps.push_back(imageOf(map));
        return made;
      },
      [this](const Made& made) {
        for (std::size_t i = 0; i < made.maps.size(); ++i) m_tiles[i + 1].map = QPixmap::fromImage(made.maps[i]);
        m_range = made.range;
        m_complete = true;
        showTiles();
      });
}

void ContactSheetWindow::showTiles() {
  m_sheet->setTiles({m_tiles.begin(), m_tiles.begin() + std::ptrdiff_t(shownCount() + 1)});
  m_sheet->setRange(m_range);
  m_save->setEnabled(m_complete);
}

void ContactSheetWindow::compareSelected() {
  const std::vector<int> tiles = m_sheet->selected();
  const std::array<QString, 2> names{m_tiles[std::size_t(tiles[0])].name, m_tiles[std::size_t(tiles[1])].name};
  using Pair = std::array<widgets::PreviewSubject, 2>;
  m_tasks.run<Pair>(
      {tr("Preparing %1 and %2").arg(names[0], names[1]), m_pairKey},
      [source = m_source, tiles](const TaskControl& control) {
        return Pair{subjectOf(source, tiles[0], control.between(0, 0.5)),
                    subjectOf(source, tiles[1], control.between(0.5, 1))};
      },
      [this, names](const Pair& subjects) { Q_EMIT compareRequested(subjects, names); },
      [this](const QString& error) { Q_EMIT failed(tr("Cannot compare the representations"), error); });
}

void ContactSheetWindow::save() {
  const QString name = m_source.name + tr(" contact sheet.png");
  const QString proposed = widgets::inDialogFolder(pictureFolder, name);
  widgets::askForPath(this, tr("Save Contact Sheet"), proposed, tr("PNG (*.png)"), [this](const QString& path) {
    widgets::rememberDialogFolder(pictureFolder, path);
    Q_EMIT saveRequested(path, m_sheet->picture(savedTile, std::min(savedColumns, int(shownCount()) + 1)));
  });
}

}  // namespace gonio::app

#include "moc_contact_sheet_window.cpp"

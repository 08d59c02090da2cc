// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Gonio authors
#include "app/gonio/study/study_sheet.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <algorithm>
#include <cmath>
#include <span>

#include "app/gonio/comparison/comparison_numbers.h"
#include "app/gonio/library/thumbnail.h"
#include "core/io/atomic_file.h"
#include "core/rendering/error_maps.h"
#include "core/study/accuracy_study.h"
#include "core/study/study_plot.h"
#include "widgets/inputs/dialogs.h"

namespace gonio::app {

namespace {

const QString pictureFolder = QStringLiteral("plot");
constexpr int side = 256, samples = 64, firstCount = 8, maxCount = 1000, minTile = 96, maxTile = 384, firstTile = 160;
constexpr int savedTile = 320, savedPdfTile = 120, maxSavedColumns = 6;

QImage imageOf(const std::vector<std::uint8_t>& rgba) {
  return QImage(rgba.data(), side, side, 4 * side, QImage::Format_RGBA8888).copy();
}

QString nameOf(const study::MeasuredRepresentation& one) {
  return QString::fromStdString(one.record.representation.shortLabel());
}

QString numbersOf(const study::StudyRecord& record) {
  const QString snr = StudySheet::tr("Rendered SNR %1 dB").arg(comparisonValue(record.renderedSnr));
  if (record.representation.kind->model)
    return StudySheet::tr("%1, %2 parameters").arg(snr).arg(record.bytes / sizeof(float));
  const QString size = QLocale().formattedDataSize(qint64(record.bytes), 1, QLocale::DataSizeSIFormat);
  if (std::isnan(record.frameMilliseconds)) return QStringLiteral("%1, %2").arg(snr, size);
  return StudySheet::tr("%1, %2, %3 per frame")
      .arg(snr, size, QString::fromStdString(study::shortQuantity(1e-3 * record.frameMilliseconds, "s")));
}

}  // namespace

widgets::PreviewSubject studiedSubject(const study::MeasuredRepresentation& studied, const TaskControl& control) {
  const auto table = studied.tabulated(control);
  return widgets::measuredSubject(table, std::make_shared<const TabulatedDensity>(*table));
}

StudySheet::StudySheet(BackgroundTasks& tasks, QWidget* parent)
    : QWidget(parent), m_tasks(tasks), m_sheet(new widgets::ContactSheet), m_hint(new QLabel(m_sheet)) {
  const QString key = QStringLiteral("study sheet %1 ").arg(quintptr(this));
  m_renderKey = key + "pictures";
  m_mapsKey = key + "maps";
  m_pairKey = key + "pair";
  build();
  showTiles();
}

StudySheet::~StudySheet() {
  for (const QString& key : {m_renderKey, m_mapsKey, m_pairKey}) m_tasks.drop(key);
}

void StudySheet::build() {
  const int em = fontMetrics().height();
  m_count = new QSpinBox;
  m_count->setRange(1, maxCount);
  m_count->setValue(firstCount);
  m_count->setToolTip(tr("Number of representations, in the order of the results"));
  m_maps = new QCheckBox(tr("Error ma&ps"));
  m_maps->setChecked(true);
  m_maps->setToolTip(tr("Shows the absolute luminance difference from the material, on one scale for all images"));
  auto* size = new QSlider(Qt::Horizontal);
  size->setRange(minTile, maxTile);
  size->setValue(firstTile);
  size->setFixedWidth(8 * em);
  size->setAccessibleName(tr("Image size"));
  size->setToolTip(size->accessibleName());
  m_compare = new QPushButton(tr("C&ompare in the Preview"));
  m_compare->setToolTip(tr("Select two images by clicking, or with the arrow keys and Space"));
  m_save = new QPushButton(tr("Sa&ve Image..."));
  m_save->setToolTip(tr("Saves the sheet as a PNG file"));
  m_savePdf = new QPushButton(tr("Save P&DF..."));
  m_savePdf->setToolTip(tr("Saves the sheet as a PDF file, with texts as text, for a paper"));
  auto* label = new QLabel(tr("Show &first"));
  label->setBuddy(m_count);
  auto* top = new QHBoxLayout;
  for (QWidget* widget : std::initializer_list<QWidget*>{label, m_count, m_maps, size}) top->addWidget(widget);
  top->addStretch();
  for (QPushButton* button : {m_compare, m_save, m_savePdf}) {
    button->setAutoDefault(false);
    top->addWidget(button);
  }
  auto* scroll = new QScrollArea;
  scroll->setWidget(m_sheet);
  scroll->setWidgetResizable(true);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setFocusProxy(m_sheet);
  m_hint->setAlignment(Qt::AlignCenter);
  m_hint->setWordWrap(true);
  m_hint->setForegroundRole(QPalette::PlaceholderText);
  auto* over = new QVBoxLayout(m_sheet);
  over->addWidget(m_hint);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(top);
  layout->addWidget(scroll, 1);
  connect(m_count, &QSpinBox::valueChanged, this, &StudySheet::work);
  connect(m_maps, &QCheckBox::toggled, m_sheet, &widgets::ContactSheet::setMapsShown);
  connect(size, &QSlider::valueChanged, m_sheet, &widgets::ContactSheet::setTileSide);
  connect(m_compare, &QPushButton::clicked, this, &StudySheet::compareSelected);
  connect(m_save, &QPushButton::clicked, this, &StudySheet::save);
  connect(m_savePdf, &QPushButton::clicked, this, &StudySheet::savePdf);
  connect(m_sheet, &widgets::ContactSheet::selectionChanged, this,
          [this] { m_compare->setEnabled(m_sheet->selected().size() == 2); });
}

void StudySheet::setSource(SheetSource source) {
  if (source.material != m_source.material) {
    for (const QString& key : {m_renderKey, m_mapsKey}) m_tasks.drop(key);
    m_comparison.reset();
    m_reference = {};
    m_mapped.clear();
  }
  m_source = std::move(source);
  std::erase_if(m_pictures, [this](const auto& one) { return !std::ranges::count(m_source.entries, one.first); });
  work();
}

void StudySheet::setRendering(bool rendering) {
  m_rendering = rendering;
  if (!rendering) m_tasks.drop(m_renderKey);
  work();
}

void StudySheet::setHint(const QString& text) { m_hint->setText(text); }

void StudySheet::setCount(int count) { m_count->setValue(count); }

std::vector<StudySheet::Entry> StudySheet::shownEntries() const {
  const std::size_t count = std::min(m_source.entries.size(), std::size_t(m_count->value()));
  return {m_source.entries.begin(), m_source.entries.begin() + std::ptrdiff_t(count)};
}

bool StudySheet::isComplete() const {
  const auto shown = shownEntries();
  return m_comparison && !shown.empty() && m_mapped.size() == shown.size() &&
         std::ranges::is_permutation(m_mapped, shown);
}

/// Renders what is missing: the reference, then one entry after the other, then the maps.
void StudySheet::work() {
  showTiles();
  if (!m_rendering || !m_source.material || m_source.entries.empty() || m_tasks.isRunning(m_renderKey)) return;
  const auto fail = [this](const QString& error) { Q_EMIT failed(tr("Cannot render the contact sheet"), error); };
  if (!m_comparison) {
    m_tasks.run<std::shared_ptr<const rendering::RenderedComparison>>(
        {tr("Rendering the contact sheet"), m_renderKey},
        [material = m_source.material](const TaskControl& control) {
          const rendering::RenderOptions options{.width = side, .height = side, .samples = samples, .density = {}};
          return std::make_shared<const rendering::RenderedComparison>(*material->material.brdf, options, control);
        },
        [this](const std::shared_ptr<const rendering::RenderedComparison>& comparison) {
          m_comparison = comparison;
          m_reference = QPixmap::fromImage(displayedImage(comparison->reference()));
          work();
        },
        fail);
    return;
  }
  const auto shown = shownEntries();
  const auto next = std::ranges::find_if(shown, [this](const Entry& one) { return !m_pictures.contains(one); });
  if (next == shown.end()) return makeMaps();
  m_tasks.run<Image>(
      {tr("Rendering %1").arg(nameOf(**next)), m_renderKey},
      [comparison = m_comparison, brdf = (*next)->brdf](const TaskControl& control) {
        return comparison->render(*brdf, control).image;
      },
      [this, entry = *next](const Image& picture) {
        if (std::ranges::count(m_source.entries, entry))
          m_pictures[entry] = {picture, QPixmap::fromImage(displayedImage(picture)), {}};
        work();
      },
      fail);
}

void StudySheet::makeMaps() {
  if (isComplete()) return;
  struct Made {
    std::vector<QImage> maps;
    double range;
  };
  const std::vector<Entry> shown = shownEntries();
  std::vector<Image> pictures;
  for (const Entry& one : shown) pictures.push_back(m_pictures.at(one).image);
  m_tasks.run<Made>(
      {.title = tr("Comparing the images"), .key = m_mapsKey, .live = true},
      [comparison = m_comparison, pictures](const TaskControl&) {
        const rendering::ErrorMaps maps = rendering::errorMaps(comparison->reference(), pictures);
        Made made{.range = maps.range};
        for (const auto& map : maps.maps) made.maps.push_back(imageOf(map));
        return made;
      },
      [this, shown](const Made& made) {
        for (std::size_t i = 0; i < shown.size(); ++i)
          if (const auto found = m_pictures.find(shown[i]); found != m_pictures.end())
            found->second.map = QPixmap::fromImage(made.maps[i]);
        m_range = made.range;
        m_mapped = shown;
        work();
      });
}

void StudySheet::showTiles() {
  std::vector<widgets::SheetTile> tiles;
  const auto shown = shownEntries();
  if (m_source.material && !shown.empty())
    tiles.push_back({m_source.name, sourceKind(*m_source.material), m_reference, {}});
  for (const Entry& one : shown) {
    const auto found = m_pictures.find(one);
    Picture picture = found == m_pictures.end() ? Picture() : found->second;
    // Until then, the small image of the study.
    if (picture.pixmap.isNull() && one->picture.width > 0)
      picture.pixmap = QPixmap::fromImage(displayedImage(one->picture));
    tiles.push_back({nameOf(*one), numbersOf(one->record), picture.pixmap, picture.map});
  }
  m_hint->setVisible(tiles.empty());
  m_sheet->setTiles(std::move(tiles));
  m_sheet->setRange(m_range);
  m_save->setEnabled(isComplete());
  m_savePdf->setEnabled(isComplete());
  m_compare->setEnabled(m_sheet->selected().size() == 2);
}

/// Tile 0 is the material.
widgets::PreviewSubject StudySheet::subjectOf(const SheetSource& source, int tile, const TaskControl& control) {
  const LoadedMaterial& material = *source.material;
  if (tile == 0) return widgets::measuredSubject(material.base, material.density);
  const study::MeasuredRepresentation& one = *source.entries[std::size_t(tile - 1)];
  if (!one.fit) return studiedSubject(one, control);
  const TabulatedBrdf* table = formOf<TabulatedBrdf>(*material.base);
  const widgets::StandaloneModel model{one.fit->model, one.fit->parameters,
                                       table ? table->grid() : HalfDifferenceGrid()};
  return {model, material.density};
}

void StudySheet::compareSelected() {
  const std::vector<int> tiles = m_sheet->selected();
  const auto tileName = [this](int tile) { return m_sheet->tiles()[std::size_t(tile)].name; };
  const std::array<QString, 2> names{tileName(tiles[0]), tileName(tiles[1])};
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

void StudySheet::save() {
  const QString name = m_source.name + tr(" contact sheet.png");
  const QString proposed = widgets::inDialogFolder(pictureFolder, name);
  widgets::askForPath(this, tr("Save Contact Sheet"), proposed, tr("PNG (*.png)"), [this](const QString& path) {
    widgets::rememberDialogFolder(pictureFolder, path);
    Q_EMIT saveRequested(path, m_sheet->picture(savedTile, savedColumns()));
  });
}

void StudySheet::savePdf() {
  const QString proposed = widgets::inDialogFolder(pictureFolder, m_source.name + tr(" contact sheet.pdf"));
  widgets::askForPath(this, tr("Save Contact Sheet"), proposed, tr("PDF (*.pdf)"), [this](const QString& path) {
    widgets::rememberDialogFolder(pictureFolder, path);
    const QByteArray bytes = m_sheet->pdf(savedPdfTile, savedColumns());
    Q_EMIT writeRequested(path, {.write = [bytes](const std::filesystem::path& file, const TaskControl&) {
                            io::writeFileAtomically(file, std::as_bytes(std::span(bytes.constData(), bytes.size())));
                          }});
  });
}

int StudySheet::savedColumns() const { return std::min(maxSavedColumns, int(shownEntries().size()) + 1); }

}  // namespace gonio::app

#include "moc_study_sheet.cpp"

// Tests the images of simulated cameras, and their times.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

#include "check.h"
#include "pioneer_controls.h"
#include "simulation.h"
#include "world_file.h"

using namespace frob::sim;

namespace
{

constexpr std::int64_t millisecond = 1'000'000;

// A Pioneer at the origin, with a camera at the robot's position that looks straight ahead.
class Seer
{
  public:
    explicit Seer(const std::string &camera, const std::string &rest, double heading = 0.0,
                  std::uint64_t seed = 1)
        : simulation_(
              parse_world("[start]\nx = 0\ny = 0\nheading_deg = " + std::to_string(heading) +
                              "\n[camera]\nahead = 0\nup = 0.25\n" + camera + "\n" + rest,
                          "test"),
              seed, false)
    {
        simulation_.look_through("camera");
    }

    // The newest frame at this time, or nullptr.
    const frob_image *at(std::int64_t time_ns)
    {
        simulation_.advance(time_ns);
        return simulation_.newest_frame(time_ns, 0);
    }

    // Ground truth of that frame.
    Truth truth() { return simulation_.frame_truth(0); }

  private:
    Simulation simulation_;
};

const std::uint8_t *pixel(const frob_image &image, int x, int y)
{
    return frob_image_row(&image, y) + frob_image_pixel_size(image.format) * x;
}

bool is_reddish(const std::uint8_t *p)
{
    return p[0] > 2 * p[1] && p[0] > 2 * p[2] && p[0] > 40;
}

struct Spot {
    double x = 0.0, y = 0.0, pixels = 0.0;
};

// The centre of the red pixels.
Spot red_spot(const frob_image &image)
{
    Spot spot;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            if (!is_reddish(pixel(image, x, y)))
                continue;
            spot.x += x, spot.y += y, ++spot.pixels;
        }
    }
    spot.x /= spot.pixels, spot.y /= spot.pixels;
    return spot;
}

std::string red_ball(double x, double y, double radius)
{
    return "[[ball]]\ncolour = \"red\"\ncenter = [" + std::to_string(x) + ", " + std::to_string(y) +
           "]\nradius = " + std::to_string(radius) + "\n";
}

// Compares the centre of a ball on the floor with where a pinhole camera shows it, by trigonometry.
void balls_are_where_they_are()
{
    struct Case {
        const char *camera;
        double heading, x, y; // the robot's heading, in degrees; the ball's position
    };
    const Case cases[] = { { "", 0, 2, 0 },
                           { "", 0, 2, 0.6 },
                           { "", 0, 3, -1.2 },
                           { "", 30, 2, 0.9 },
                           { "yaw_deg = 20", 0, 2, 0.9 },
                           { "pitch_deg = 15", 0, 1.5, 0.2 },
                           { "width = 640\nheight = 480\nfield_of_view_deg = 90", 0, 1.2, 0.4 } };
    for (const Case &c : cases) {
        Seer seer(c.camera, red_ball(c.x, c.y, 0.08), c.heading);
        const frob_image &image = *seer.at(0);
        const frob_camera &lens = image.camera;
        const double turn = radians(c.heading) + lens.yaw_rad;
        const double ahead = std::cos(turn) * c.x + std::sin(turn) * c.y;
        const double left = -std::sin(turn) * c.x + std::cos(turn) * c.y, up = 0.08 - lens.z_m;
        const double along = std::cos(lens.pitch_rad) * ahead - std::sin(lens.pitch_rad) * up;
        const double above = std::sin(lens.pitch_rad) * ahead + std::cos(lens.pitch_rad) * up;
        const Spot seen = red_spot(image);
        const double x = lens.centre_x - lens.focal_x * left / along;
        const double y = lens.centre_y - lens.focal_y * above / along;
        const bool is_there = std::hypot(seen.x - x, seen.y - y) < 1.0;
        check::that(is_there, "a ball is seen where it is");
        if (!is_there)
            std::printf("  %g %g, not %g %g\n", seen.x, seen.y, x, y);
        // The disc's area matches its angle to 15 %; it is a little wider off the axis.
        const double radius = lens.focal_x * 0.08 / along;
        check::near(seen.pixels / (pi * radius * radius), 1.0, 0.15, "and as large as it is");
    }
}

void roll_is_clockwise()
{
    Seer seer("roll_deg = 90\nheight = 320", red_ball(2, 0.5, 0.08));
    const Spot seen = red_spot(*seer.at(0));
    check::that(seen.y > 200, "rolled clockwise, what is on the left is at the bottom");
}

// Reads the cells of tag 0 and compares them with the family's: the second row inside the frame is
// 110101 ….
void tags_are_readable()
{
    Seer seer("width = 640\nheight = 480",
              "[[tag]]\nid = 0\ncenter = [1, 0]\nfacing_deg = 180\nsize = 0.4\nmiddle = 0.25\n");
    const frob_image &image = *seer.at(0);
    const double scale = image.camera.focal_x / (1.0 - 0.004) * 0.05; // pixels per cell
    const auto is_white = [&](int column, int row) {
        const double x = image.camera.centre_x + (column - 4.5) * scale;
        const double y = image.camera.centre_y + (row - 4.5) * scale;
        return pixel(image, static_cast<int>(x + 0.5), static_cast<int>(y + 0.5))[0] > 80;
    };
    const char *const rows[] = { "1111111111", "1000000001", "1011010101", "1001110101",
                                 "1001100001", "1010100001", "1001011001", "1000010001",
                                 "1000000001", "1111111111" };
    bool all = true;
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 10; ++column)
            all = all && is_white(column, row) == (rows[row][column] == '1');
    check::that(all, "a tag is the right way round");
}

void near_hides_far()
{
    Seer seer("", "[[box]]\ncenter = [1, 0]\nsize = [0.2, 0.2]\nheight = 0.5\ncolour = \"blue\"\n" +
                      red_ball(2, 0, 0.1) + red_ball(2, 0.8, 0.1));
    const frob_image &image = *seer.at(0);
    const Spot seen = red_spot(image);
    check::that(seen.x < 100 && seen.pixels > 100,
                "a ball behind a box is hidden, one beside it is not");
}

// A low wall 2 m away, and a ball in front of it.
void truth_is_geometry()
{
    const std::string wall = "[[wall]]\npoints = [[2.05, -3], [2.05, 3]]\nheight = 0.5\n";
    Seer seer("noise = 20\nblur = 2", wall + red_ball(1, 0, 0.1));
    const frob_camera lens = seer.at(0)->camera;
    const Truth truth = seer.truth();
    const auto is = [&](int x, int y, Thing::Kind kind) {
        return truth.thing_at(x, y) == Thing{ kind, 0 };
    };
    check::that(is(10, 120, Thing::Kind::wall) && is(160, 118, Thing::Kind::wall),
                "truth: a wall, behind the ball too");
    check::near(truth.depth_at(10, 120), 2.0, 1e-6, "2 m away along the axis, at the side");
    check::near(truth.depth_at(160, 118), 2.0, 1e-6, "and in the middle");
    // The ray through its centre meets it one radius earlier.
    const int low = static_cast<int>(std::lround(lens.centre_y + lens.focal_y * 0.15));
    check::that(is(160, low, Thing::Kind::ball), "a ball in front");
    check::near(truth.depth_at(160, low), 1.0 - 0.1 / std::hypot(1.0, 0.15), 1e-4,
                "a radius nearer than its middle");
    check::that(is(10, 230, Thing::Kind::floor), "the floor");
    check::near(truth.depth_at(10, 230), 0.25 * lens.focal_y / (230 - lens.centre_y), 1e-6,
                "as far as its row says");
    check::that(is(10, 5, Thing::Kind::sky) && std::isinf(truth.depth_at(10, 5)),
                "the sky, infinitely far");
    // The lens moves points towards the centre, also those next to the ball.
    Seer round("k1 = -0.2", wall + red_ball(1, 0, 0.1));
    const frob_camera bent = round.at(0)->camera;
    const Truth seen = round.truth();
    const double a = 0.4, shrunk = a * (1.0 - 0.2 * a * a); // in focal lengths from the axis
    Seer post("k1 = -0.2", "[[circle]]\ncenter = [2, -0.8]\nradius = 0.02\n");
    check::that(post.at(0) != nullptr, "a post");
    const Truth posts = post.truth();
    const int column = static_cast<int>(std::lround(bent.centre_x + bent.focal_x * shrunk));
    check::that(posts.thing_at(column, 120) == Thing{ Thing::Kind::circle, 0 } &&
                    posts.thing_at(static_cast<int>(bent.centre_x + bent.focal_x * a), 120) !=
                        Thing{ Thing::Kind::circle, 0 },
                "with a lens that distorts it is where the picture has it");
    check::near(seen.depth_at(10, 120), 2.0, 1e-6, "as far as it is");
}

// The centre of a white wall 2 m away, and its left side; the light decreases with the square of
// the distance.
void light_falls_off()
{
    const std::string wall = "[[wall]]\npoints = [[2.05, -3], [2.05, 3]]\ncolour = \"#ffffff\"\n"
                             "texture = \"plain\"\n";
    const auto lit = [&](const std::string &light, int x, const std::string &things) {
        Seer seer("", light + things);
        return static_cast<double>(*pixel(*seer.at(0), x, 120));
    };
    // 60 cd at a distance of 2 m, on a surface that faces the lamp: 15 lx.
    const std::string lamp = "[[lamp]]\nposition = [0, 0]\nheight = 0.25\n";
    const std::string dim = "[ambient]\nwhite = 30\n";
    check::near(lit(lamp + dim, 160, wall), 127.5, 1.0, "light: half of what is white");
    const double aside = 159.5 / 160.0 * std::tan(pi / 6);
    check::near(lit(lamp + dim, 0, wall), 127.5 / std::pow(1.0 + aside * aside, 1.5), 1.0,
                "at the side less, as that is farther away and askew");
    const std::string far = "[[lamp]]\nposition = [-2, 0]\nheight = 0.25\n";
    check::near(lit(far + dim, 160, wall), 127.5 / 4, 1.0, "a quarter from twice as far away");
    check::near(lit(far + lamp + dim, 160, wall), 127.5 * 1.25, 1.0, "two lamps together");
    const std::string behind = "[[lamp]]\nposition = [3, 0]\nheight = 0.25\n";
    check::near(lit(behind + dim, 160, wall), 0.0, 0.0, "nothing from behind");
    check::near(lit(behind + dim + "light = 15\n", 160, wall), 0.5 * lit("", 160, wall), 1.0,
                "the light of the room is as it is without `white`");
    // At its visible centre, a ball faces the lamp at the camera.
    Seer seer("", lamp + "[ambient]\nwhite = 144.5\n" +
                      "[[ball]]\ncenter = [1, 0]\nradius = 0.1\ncolour = \"#ffffff\"\n");
    const frob_image &image = *seer.at(0);
    const double way = std::hypot(1.0, 0.15) - 0.1;
    check::near(
        *pixel(image, 160,
               static_cast<int>(std::lround(image.camera.centre_y + image.camera.focal_y * 0.15))),
        255.0 * 60.0 / (way * way) / 144.5, 2.0, "a ball, where it faces the lamp");
}

void time_passes()
{
    Seer late("rate = 20\nlatency = 0.12", "");
    check::that(late.at(115 * millisecond) == nullptr, "nothing comes before its time");
    const frob_image *first = late.at(120 * millisecond);
    check::that(first != nullptr && first->number == 0 && first->captured_ns == 0,
                "then the first frame");
    check::that(late.at(125 * millisecond) == nullptr, "once");
    const frob_image *newest = late.at(330 * millisecond);
    check::that(newest != nullptr && newest->number == 4 &&
                    newest->captured_ns == 200 * millisecond,
                "of several the newest");
    Seer lossy("dropout = 0.5\nrate = 100", "");
    int came = 0;
    std::uint32_t last = 0;
    for (int k = 0; k < 200; ++k) {
        if (const frob_image *frame = lossy.at(k * 10 * millisecond)) {
            ++came;
            last = frame->number;
        }
    }
    check::that(came > 70 && came < 130 && last > 190, "lost frames do not come, and are counted");
}

// The column of a red ball 2 m ahead in both cameras of a stereo pair, and further data.
struct Pair {
    explicit Pair(const std::string &stereo, std::int64_t time_ns = 0)
        : simulation(parse_world("[start]\nx = 0\ny = 0\nheading_deg = 30\n[stereo]\nahead = 0.1\n"
                                 "left = 0.03\nup = 0.1\n" +
                                     stereo + "\n" +
                                     red_ball(2.1 * 0.8660254 - 0.03 * 0.5,
                                              2.1 * 0.5 + 0.03 * 0.8660254, 0.1),
                                 "test"),
                     1, false)
    {
        const auto left_number = simulation.look_through("left");
        const auto right_number = simulation.look_through("right");
        simulation.advance(time_ns);
        left = simulation.newest_frame(time_ns, *left_number);
        right = simulation.newest_frame(time_ns, *right_number);
    }

    double disparity() const { return red_spot(*left).x - red_spot(*right).x; }
    double rise() const { return red_spot(*left).y - red_spot(*right).y; }

    Simulation simulation;
    const frob_image *left = nullptr, *right = nullptr;
};

bool is_near(double x, double y, double off)
{
    return std::abs(x - y) < off;
}

void pairs_have_disparities()
{
    const Pair straight("baseline = 0.2");
    const double focal = straight.left->camera.focal_x;
    check::that(is_near(straight.disparity(), focal * 0.2 / 2.0, 0.3) &&
                    is_near(straight.rise(), 0.0, 0.1),
                "focal length times baseline over distance, in the same rows");
    check::that(is_near(straight.left->camera.y_m, 0.13, 1e-9) &&
                    is_near(straight.right->camera.y_m, -0.07, 1e-9),
                "the cameras are on both sides of where the head sits");
    const Pair yawed("baseline = 0.2\naskew_yaw_deg = 1");
    check::that(is_near(yawed.disparity() - straight.disparity(), -focal * 0.0174533, 0.3) &&
                    yawed.right->camera.yaw_rad == 0.0,
                "a right camera that looks to the left has larger columns, and nobody is told");
    const Pair pitched("baseline = 0.2\naskew_pitch_deg = 1");
    check::that(is_near(pitched.rise() - straight.rise(), focal * 0.0174533, 0.3),
                "one that looks down has smaller rows");
    const Pair turned("baseline = 0.2\nyaw_deg = 10\nroll_deg = 90");
    check::that(is_near(turned.left->camera.z_m, 0.2, 1e-9) &&
                    is_near(turned.right->camera.z_m, 0.0, 1e-9) &&
                    is_near(turned.left->camera.y_m, 0.03, 1e-9),
                "with the head on its side one camera is above the other");
}

void pairs_are_of_one_time()
{
    bool same = true;
    int lost = 0;
    for (int k = 1; k < 60; ++k) {
        const Pair pair("rate = 50\njitter = 0.008\ndropout = 0.3\nnoise = 5",
                        k * 20 * millisecond);
        same = same && (pair.left == nullptr) == (pair.right == nullptr);
        if (pair.left == nullptr)
            continue;
        same = same && pair.left->captured_ns == pair.right->captured_ns &&
               pair.left->number == pair.right->number;
        lost += pair.left->captured_ns < (k - 1) * 20 * millisecond - 8 * millisecond;
    }
    check::that(same, "both cameras of a head take and lose their frames together");
    check::that(lost > 5, "and some are lost");
}

// A ball passes by, and a robot turns in front of a post; rows are exposed from the first to the
// last.
void rows_roll()
{
    Seer seer("rate = 10\nrolling = 0.1",
              "[[ball]]\ncolour = \"red\"\nway = [[2, -2], [2, 2]]\nspeed = 2\nradius = 0.08\n");
    seer.at(500 * millisecond);
    check::that(seer.at(595 * millisecond) == nullptr, "rolling: a frame comes with its last row");
    const frob_image &image = *seer.at(600 * millisecond);
    check::that(image.number == 5 && image.captured_ns == 500 * millisecond,
                "and is of the time of its first");
    const Spot spot = red_spot(image);
    const double left = -2.0 + 2.0 * (0.5 + 0.1 * spot.y / (image.height - 1));
    check::near(spot.x, image.camera.centre_x - image.camera.focal_x * left / 2.0, 1.0,
                "what moves is where it is at the time of its row");

    Simulation turning(
        parse_world("[start]\nx = 0\ny = 0\nheading_deg = 150\n"
                    "[camera]\nahead = 0\nup = 0.25\nrolling = 0.03\n"
                    "[[circle]]\ncenter = [-2, 0]\nradius = 0.02\ncolour = \"red\"\n",
                    "test"),
        1, false);
    const auto camera = turning.look_through("camera");
    command(turning, 0, drive(0.0, 1.0));
    bool is_slanted = false;
    for (std::int64_t t = 0; t < 1200 * millisecond; t += 5 * millisecond) {
        turning.advance(t);
        const frob_image *frame = turning.newest_frame(t, *camera);
        if (t < 700 * millisecond || frame == nullptr)
            continue;
        const auto column = [&](int y) {
            double sum = 0.0, count = 0.0;
            for (int x = 0; x < frame->width; ++x)
                if (is_reddish(pixel(*frame, x, y)))
                    sum += x, ++count;
            return sum / count;
        };
        const double shift = column(130) - column(70), focal = frame->camera.focal_x;
        if (std::abs(column(100) - frame->camera.centre_x) > 60.0)
            continue;
        is_slanted = true;
        check::near(shift, focal * 0.03 * 60.0 / (frame->height - 1), 0.8,
                    "a post leans as it turns");
        break;
    }
    check::that(is_slanted, "a post was seen");
}

std::uint64_t hash(const frob_image &image)
{
    std::uint64_t h = 0xcbf29ce484222325u;
    const auto size =
        static_cast<std::size_t>(image.stride) * static_cast<std::size_t>(image.height);
    for (std::size_t i = 0; i < size; ++i)
        h = (h ^ static_cast<const std::uint8_t *>(image.pixels)[i]) * 0x100000001b3u;
    return h;
}

// A world with one thing of each kind.
const char *const all_things =
    "[[wall]]\npoints = [[-3, -2], [5, -2], [5, 2], [-3, 2]]\nclosed = true\ntexture = \"bricks\"\n"
    "[[circle]]\ncenter = [3, 1]\nradius = 0.2\ntexture = \"stripes\"\n"
    "[[polygon]]\npoints = [[3, -1.5], [4, -1.5], [3.5, -0.8]]\ncolour = \"#336699\"\n"
    "[[box]]\ncenter = [2, -0.6]\nsize = [0.3, 0.4]\nangle_deg = 30\ntexture = \"checks\"\n"
    "[[ball]]\nway = [[1.5, 0.3], [2.5, 0.6]]\nspeed = 0.3\n"
    "[[cone]]\ncenter = [2.4, 0.1]\n"
    "[[tag]]\nid = 5\ncenter = [4.9, 0.5]\nfacing_deg = 180\nsize = 0.5\n"
    "[[tape]]\npoints = [[0.5, -0.3], [4, -0.3], [4, 0.5]]\nradius = 0.3\n"
    "[[patch]]\npoints = [[1, 0.5], [2, 0.5], [2, 1.5], [1, 1.5]]\ncolour = \"green\"\n"
    "[[hole]]\npoints = [[2.5, 1.2], [2.9, 1.2], [2.9, 1.6], [2.5, 1.6]]\n"
    "[sky]\ncolour = \"white\"\n";
const char *const all_faults =
    "noise = 5\nblur = 1\nk1 = -0.2\nk2 = 0.03\npitch_deg = 8\nroll_deg = 2\n"
    "exposure = 1.1\njitter = 0.003\n";

void truth_knows_all_things()
{
    Simulation simulation(
        parse_world("[[start]]\nx = 0\ny = 0\n[[start]]\nx = 2\ny = 1.2\n[camera]\n" +
                        std::string(all_faults) + all_things,
                    "test"),
        1, false);
    const auto camera = simulation.look_through("camera");
    const frob_image &image = *simulation.newest_frame(0, *camera);
    const Truth truth = simulation.frame_truth(*camera);
    std::vector<int> pixels(static_cast<std::size_t>(Thing::Kind::patch) + 1);
    bool is_one = true;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const Thing thing = truth.thing_at(x, y);
            ++pixels[static_cast<std::size_t>(thing.kind)];
            is_one = is_one && thing.number == (thing.kind == Thing::Kind::robot ? 1 : 0);
        }
    }
    // The walls hide the sky.
    const bool are_all = pixels[0] == 0 && *std::min_element(pixels.begin() + 1, pixels.end()) > 10;
    check::that(are_all, "truth: each kind of thing is somewhere");
    check::that(is_one, "and has its number");
    if (!are_all)
        for (const int count : pixels)
            std::printf("  %d\n", count);
}

// The number comes from one machine; all machines must produce it.
void pixels_are_the_same_everywhere()
{
    Seer seer(all_faults, all_things);
    const std::uint64_t first = hash(*seer.at(0));
    const std::uint64_t expected = 0xc0ad0b38f1ae9e4au;
    check::that(first == expected, "the same pixels on every machine");
    if (first != expected)
        std::printf("  0x%016llx\n", static_cast<unsigned long long>(first));
    Seer again(all_faults, all_things), other(all_faults, all_things, 0.0, 2);
    check::that(hash(*again.at(0)) == first, "and in every run of a seed");
    check::that(hash(*other.at(0)) != first, "and others of another");
}

void mistakes_are_told()
{
    const auto told = [](const char *world) {
        try {
            parse_world(std::string("[start]\nx = 0\ny = 0\n") + world, "w");
        } catch (const WorldFileError &error) {
            return std::string(error.what());
        }
        return std::string();
    };
    check::that(told("[[ball]]\ncenter = [1, 1]\ncolour = \"mauve\"\n") ==
                    "w:6:10: there is no colour `mauve`; the colours are white, grey, black, red, "
                    "orange, yellow, green, blue, purple, pink, brown, and `#rrggbb`",
                "no colour");
    check::that(told("[[cone]]\ncenter = [1, 1]\ntexture = \"fur\"\n") ==
                    "w:6:11: there is no texture `fur`; the textures are plain, plaster, bricks, "
                    "stripes, checks",
                "no texture");
    check::that(told("[[tag]]\nid = 30\ncenter = [1, 1]\nfacing_deg = 0\nsize = 0.1\n") ==
                    "w:5:6: `id` must be a whole number from 0 to 29",
                "no tag");
    check::that(
        told(
            "[[poster]]\npicture = \"no.ppm\"\ncenter = [1, 1]\nfacing_deg = 0\nsize = [1, 1]\n") ==
            "w:5:11: no.ppm: cannot read this picture",
        "no picture");
    check::that(told("[[camera]]\n[[camera]]\nwidth = 100\n") ==
                    "w:1:1: two cameras are named `camera`: give each one its own `name`",
                "two of a name");
    check::that(told("[stereo]\nbaseline = 0\nname = \"head\"\n") ==
                    "w:5:12: `baseline` must be more than zero\n"
                    "w:6:1: unknown key `name`; did you mean `rate`?",
                "a head of one camera");
    check::that(told("[camera]\nrate = 20\nrolling = 0.06\n") ==
                    "w:6:11: `rolling` must be at most 1 / `rate`, the time between frames",
                "rows too slow");
    check::that(told("[ambient]\nwhite = 100\n") ==
                    "w:5:9: with `white`, cameras need light, but this world has none: "
                    "add `light`, or a table [[lamp]]",
                "no light");
    check::that(told("[ambient]\nwhite = 0\nlight = 10\n") ==
                    "w:5:9: `white` must be more than zero",
                "nothing is white");
    check::that(told("[[ball]]\nway = [[1, 1], [2, 2]]\n") == "w:4:1: this needs a key `speed`",
                "a way without a speed");
}

} // namespace

int main()
{
    balls_are_where_they_are();
    roll_is_clockwise();
    tags_are_readable();
    near_hides_far();
    truth_is_geometry();
    light_falls_off();
    truth_knows_all_things();
    time_passes();
    rows_roll();
    pairs_have_disparities();
    pairs_are_of_one_time();
    pixels_are_the_same_everywhere();
    mistakes_are_told();
    return check::status();
}

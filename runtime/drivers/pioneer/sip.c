#include "drivers/pioneer/sip.h"

#include <string.h>

#include "drivers/pioneer/protocol.h"

/* Reads a body field by field. Past the end, every field is 0 and `short_` is set. */
struct cursor {
    const uint8_t *at;
    size_t left;
    bool short_;
};

static uint8_t u8(struct cursor *c)
{
    if (c->left < 1) {
        c->short_ = true;
        return 0;
    }
    c->left--;
    return *c->at++;
}

static uint16_t u16(struct cursor *c)
{
    uint16_t low, high;
    if (c->left < 2) {
        c->short_ = true;
        c->left = 0;
        return 0;
    }
    low = u8(c);
    high = u8(c);
    return (uint16_t)(low | high << 8);
}

/* Converts from two's complement without relying on an implementation-defined
 * conversion. */
static int16_t s16(struct cursor *c)
{
    int32_t n = u16(c);
    return (int16_t)(n >= 0x8000 ? n - 0x10000 : n);
}

/* Reads a NUL-terminated string, and truncates it to `size`. */
static void text(struct cursor *c, char *room, size_t size)
{
    size_t length = 0;
    for (;;) {
        uint8_t byte = u8(c);
        if (byte == 0)
            break;
        if (length + 1 < size)
            room[length++] = byte >= 0x20 && byte < 0x7F ? (char)byte : '?';
    }
    room[length] = '\0';
}

bool frob_p2os_read_sip(const struct frob_p2os_packet *packet, struct frob_p2os_sip *sip)
{
    struct cursor c = { packet->body, packet->length, false };
    uint8_t type = u8(&c), low, high, count;
    memset(sip, 0, sizeof *sip);
    if (!FROB_P2OS_IS_SIP(type))
        return false;
    sip->moving = type == FROB_P2OS_TYPE_SIP_MOVING;
    sip->x = u16(&c) & 0x7FFFu;
    sip->y = u16(&c) & 0x7FFFu;
    sip->heading = s16(&c);
    sip->left = s16(&c);
    sip->right = s16(&c);
    sip->battery = u8(&c);
    low = u8(&c);
    high = u8(&c);
    sip->left_stall = (low & 1u) != 0;
    sip->right_stall = (high & 1u) != 0;
    sip->rear_bumpers = (uint8_t)(low >> 1);
    sip->front_bumpers = (uint8_t)(high >> 1);
    s16(&c); /* control: the heading's setpoint */
    sip->flags = u16(&c);
    sip->compass = u8(&c);
    count = u8(&c);
    if (c.short_ || c.left < 3u * count)
        return false;
    for (uint8_t i = 0; i < count; i++) {
        struct frob_p2os_echo echo;
        echo.transducer = u8(&c);
        echo.range = u16(&c);
        if (echo.transducer < FROB_P2OS_SONARS_MOST && sip->echo_count < FROB_P2OS_SONARS_MOST)
            sip->echoes[sip->echo_count++] = echo;
    }
    u8(&c); /* gripper */
    u8(&c); /* analog port */
    u8(&c); /* analog */
    u8(&c); /* digital in */
    u8(&c); /* digital out */
    sip->battery_fine = u16(&c);
    sip->known |= c.short_ ? 0u : (unsigned)FROB_P2OS_KNOWN_BATTERY;
    sip->charge_state = u8(&c);
    sip->known |= c.short_ ? 0u : (unsigned)FROB_P2OS_KNOWN_CHARGE;
    sip->turn_rate = s16(&c);
    sip->known |= c.short_ ? 0u : (unsigned)FROB_P2OS_KNOWN_TURN_RATE;
    sip->faults = u16(&c);
    sip->known |= c.short_ ? 0u : (unsigned)FROB_P2OS_KNOWN_FAULTS;
    return true;
}

bool frob_p2os_read_config(const struct frob_p2os_packet *packet,
                           struct frob_p2os_robot_config *config)
{
    struct cursor c = { packet->body, packet->length, false };
    char skipped[1];
    if (u8(&c) != FROB_P2OS_TYPE_CONFIG)
        return false;
    text(&c, skipped, sizeof skipped); /* type */
    text(&c, skipped, sizeof skipped); /* subtype */
    text(&c, skipped, sizeof skipped); /* serial number */
    u8(&c);
    config->turn_top = u16(&c);
    config->speed_top = u16(&c);
    u16(&c);                           /* rotational acceleration */
    u16(&c);                           /* translational acceleration */
    u16(&c);                           /* maximum PWM */
    text(&c, skipped, sizeof skipped); /* name */
    config->sip_period = u8(&c);
    u8(&c);  /* host baud */
    u8(&c);  /* aux baud */
    u16(&c); /* gripper */
    u16(&c); /* front sonar */
    u8(&c);  /* rear sonar */
    u16(&c); /* low battery */
    u16(&c); /* rev count */
    config->watchdog = u16(&c);
    return !c.short_;
}

bool frob_p2os_read_identity(const struct frob_p2os_packet *packet,
                             struct frob_p2os_identity *identity)
{
    struct cursor c = { packet->body, packet->length, false };
    if (u8(&c) != FROB_P2OS_SYNC2)
        return false;
    text(&c, identity->name, sizeof identity->name);
    text(&c, identity->robot_class, sizeof identity->robot_class);
    text(&c, identity->subclass, sizeof identity->subclass);
    return !c.short_;
}

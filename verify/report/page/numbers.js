// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers as they are: doubles bit by bit, fractions exactly (BigInt), and the difference of the two.

/** A fraction {n, d} of BigInts, d > 0; not reduced. */
export function fractionOf(text) {
    const [n, d] = text.split("/");
    return { n: BigInt(n), d: BigInt(d ?? 1) };
}

/** A finite double as m * 2^e with BigInt m. */
export function binary(x) {
    const view = new DataView(new ArrayBuffer(8));
    view.setFloat64(0, x);
    const bits = view.getBigUint64(0);
    const biased = Number((bits >> 52n) & 0x7ffn);
    const rest = bits & 0xfffffffffffffn;
    const m = biased === 0 ? rest : rest | (1n << 52n);
    return { m: bits >> 63n ? -m : m, e: (biased === 0 ? 1 : biased) - 1075 };
}

/** A finite double as a fraction, exactly. */
export function fractionOfDouble(x) {
    const { m, e } = binary(x);
    return e >= 0 ? { n: m << BigInt(e), d: 1n } : { n: m, d: 1n << BigInt(-e) };
}

export function minus(p, q) {
    return { n: p.n * q.d - q.n * p.d, d: p.d * q.d };
}

/** -1, 0 or 1 as p is less than, equal to or greater than q. */
export function compareFractions(p, q) {
    const left = p.n * q.d;
    const right = q.n * p.d;
    return left < right ? -1 : left > right ? 1 : 0;
}

function bitLength(n) {
    return n === 0n ? 0 : n.toString(2).length;
}

/** The double nearest to n / d (where that is not denormal). */
export function nearestDouble({ n, d }) {
    if (n === 0n) return 0;
    const negative = n < 0n;
    const size = negative ? -n : n;
    const shift = 70 - (bitLength(size) - bitLength(d));
    const scaled = shift >= 0 ? size << BigInt(shift) : size;
    const divisor = shift >= 0 ? d : d << BigInt(-shift);
    let quotient = scaled / divisor;
    if (quotient * divisor !== scaled) quotient |= 1n;  // not exact: never seen as a tie
    // In two steps: 2^-shift itself may be out of range.
    const half = Math.trunc(-shift / 2);
    const value = Number(quotient) * 2 ** half * 2 ** (-shift - half);
    return negative ? -value : value;
}

/** n / d in decimals with `digits` significant digits, cut off; "0" for nothing. */
export function decimals({ n, d }, digits) {
    if (n === 0n) return "0";
    const negative = n < 0n;
    const size = negative ? -n : n;
    let exponent = Math.floor((bitLength(size) - bitLength(d)) * Math.LOG10E * Math.LN2) + 1;
    const cut = () => {
        const power = digits - 1 - exponent;
        return power >= 0 ? (size * 10n ** BigInt(power)) / d : size / (d * 10n ** BigInt(-power));
    };
    let mantissa = cut();
    while (mantissa.toString().length < digits) { --exponent; mantissa = cut(); }
    while (mantissa.toString().length > digits) { ++exponent; mantissa = cut(); }
    const text = mantissa.toString();
    const sign = negative ? "−" : "";
    if (exponent === 0) return `${sign}${text[0]}.${text.slice(1)}`;
    if (exponent < 0 && exponent > -5) return `${sign}0.${"0".repeat(-exponent - 1)}${text}`;
    return `${sign}${text[0]}.${text.slice(1)}e${exponent}`;
}

/** As C's %a writes it. */
export function hexadecimal(x) {
    if (x === 0) return Object.is(x, -0) ? "-0x0p+0" : "0x0p+0";
    let { m, e } = binary(x);
    const sign = m < 0n ? "-" : "";
    if (m < 0n) m = -m;
    const lead = m >> 52n;
    const digits = (m & 0xfffffffffffffn).toString(16).padStart(13, "0").replace(/0+$/, "");
    const exponent = e + 52;
    return `${sign}0x${lead}${digits ? "." + digits : ""}p${exponent < 0 ? "" : "+"}${exponent}`;
}

/** Three significant digits, as "4.48e-16", "0.345" or "0". */
export function short(x) {
    if (x === null || x === undefined) return "∞";
    if (x === 0) return "0";
    const size = Math.abs(x);
    if (size >= 1.7e308) return "∞";
    return size >= 1e-3 && size < 1e4 ? String(Number(x.toPrecision(3))) : Number(x.toPrecision(3)).toExponential();
}

/** The 16-bit float with these bits. */
export function halfFloat(bits) {
    const sign = bits & 0x8000 ? -1 : 1;
    const exponent = (bits >> 10) & 31;
    const part = bits & 1023;
    if (exponent === 31) return part ? NaN : sign * Infinity;
    return exponent === 0 ? sign * part * 2 ** -24 : sign * (1024 + part) * 2 ** (exponent - 25);
}

use serde::{Deserialize, Serialize};
use std::fmt;

/// Declares the units with their symbols, which are also their names in files.
macro_rules! units {
    ($($name:ident = $symbol:literal $doc:literal,)*) => {
        /// A unit of measurement.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
        pub enum Unit {
            $(#[doc = $doc] #[serde(rename = $symbol)] $name,)*
        }

        impl Unit {
            /// Every unit, in the order of declaration.
            pub const ALL: &[Self] = &[$(Self::$name,)*];

            /// Symbol in ASCII, like `mm/s^2`.
            pub fn symbol(self) -> &'static str {
                match self {
                    $(Self::$name => $symbol,)*
                }
            }
        }
    };
}

units! {
    One = "1" "A number without a unit.",
    Mm = "mm" "Millimetre.",
    Mm2 = "mm^2" "Square millimetre.",
    M2 = "m^2" "Square metre.",
    M3 = "m^3" "Cubic metre.",
    Um = "um" "Micrometre.",
    M = "m" "Metre.",
    Deg = "deg" "Degree.",
    PerM = "1/m" "Per metre.",
    Rad = "rad" "Radian.",
    MmPerS = "mm/s" "Millimetre per second.",
    MmPerS2 = "mm/s^2" "Millimetre per second squared.",
    MmPerS3 = "mm/s^3" "Millimetre per second cubed.",
    DegPerS = "deg/s" "Degree per second.",
    DegPerS2 = "deg/s^2" "Degree per second squared.",
    DegPerS3 = "deg/s^3" "Degree per second cubed.",
    MmPerMin = "mm/min" "Millimetre per minute.",
    MPerMin = "m/min" "Metre per minute.",
    LPerMin = "l/min" "Litre per minute.",
    S = "s" "Second.",
    H = "h" "Hour.",
    Ms = "ms" "Millisecond.",
    Us = "us" "Microsecond.",
    Ns = "ns" "Nanosecond.",
    Hz = "Hz" "Hertz.",
    KiloHz = "kHz" "Kilohertz.",
    Percent = "%" "Percent.",
    A = "A" "Ampere.",
    MilliA = "mA" "Milliampere.",
    V = "V" "Volt.",
    KiloV = "kV" "Kilovolt.",
    N = "N" "Newton.",
    NM = "N m" "Newton metre.",
    W = "W" "Watt.",
    KiloW = "kW" "Kilowatt.",
    Kg = "kg" "Kilogram.",
    L = "l" "Litre.",
    KiloJ = "kJ" "Kilojoule.",
    KiloWh = "kWh" "Kilowatt-hour.",
    KiloJPerMm = "kJ/mm" "Kilojoule per millimetre.",
    Mbar = "mbar" "Millibar.",
    Bar = "bar" "Bar.",
    DegC = "degC" "Degree Celsius.",
    K = "K" "Kelvin.",
    Px = "px" "Pixel.",
    Db = "dB" "Decibel.",
    Byte = "B" "Byte.",
    MiB = "MiB" "Mebibyte.",
}

impl Unit {
    /// The unit with this symbol.
    pub fn from_symbol(symbol: &str) -> Option<Self> {
        Self::ALL.iter().copied().find(|unit| unit.symbol() == symbol)
    }

    /// Identifier of the unit in catalogues, like `unit-mm-per-s2`.
    pub fn identifier(self) -> String {
        let name = self.symbol().replace('/', "-per-").replace('^', "").replace('%', "percent").replace(' ', "-");
        format!("unit-{name}")
    }
}

impl fmt::Display for Unit {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(self.symbol())
    }
}

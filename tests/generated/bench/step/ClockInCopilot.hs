-- | The language's promise about time, in Copilot: dt counts in whole nanoseconds.
module ClockInCopilot (nanoseconds, seconds) where

import Language.Copilot
import Prelude ()

-- | Since the instant before; adding and taking away 2^52 leaves no bits for a
-- fraction. NaN and negative give 0; at most 10^18.
nanoseconds :: Stream Double
nanoseconds = mux (ns > 0) (mux (ns < big) ((ns + big) - big) (mux (ns < 1e18) ns 1e18)) 0
  where
    ns = extern "dt" Nothing * 1e9
    big = 4503599627370496

seconds :: Stream Double
seconds = nanoseconds / 1e9

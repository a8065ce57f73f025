// SPDX-License-Identifier: BSD-3-Clause
// The frame's constants, read once: in the loops each use would be a load.
FrameBuffer constants; // for what few variants read
Bricks bricks;
Indices brickLists;
TransferBins transferBins;
TransferKnots transferKnots;
float stepScale;
float transmittanceExponent;
float fixedStep;
float jitterOfPixel; // in (0, 1)
float integralUnit;
float inverseIntegralUnit;
float terminationOpacity;
vec2 averageRange;

void readConstants(FrameBuffer f)
{
  constants = f;
  bricks = Bricks(f.frame.bricks);
  brickLists = Indices(f.frame.brickLists);
  transferBins = TransferBins(f.frame.transferBins);
  transferKnots = TransferKnots(f.frame.transferKnots);
  stepScale = f.frame.stepScale;
  transmittanceExponent = f.frame.transmittanceExponent;
  fixedStep = f.frame.fixedStep;
  integralUnit = f.frame.integralUnit;
  inverseIntegralUnit = 1.0 / integralUnit;
  terminationOpacity = f.frame.terminationOpacity;
  averageRange = vec2(f.frame.leastToAverage.x, f.frame.mostToAverage.x);
}

#pragma once
// A room of OpenCOVER.

#include <string>

namespace carom::test::cover {

/// A room of two walls with a computer for each eye, whose master shows a preview. Later sections win: the
/// width of the side wall and the windows come from the end of the file.
inline const std::string kCave = R"(<?xml version="1.0"?>
<COCONFIG>
 <LOCAL HOST="f1,f2">
  <COVER><ScreenConfig><Screen name="0" comment="FRONT" width="4000" height="3000" originX="0" originY="2000" originZ="0" h="0" p="0" r="0"/>
  </ScreenConfig></COVER>
 </LOCAL>
 <LOCAL host="s1,s2">
  <COVER><ScreenConfig><Screen name="0" comment="LEFT" width="1" height="3000" originX="-2000" originY="0" originZ="0" h="90" p="0" r="0"/>
   <Screen name="1" comment="SPARE" width="100" height="100"/></ScreenConfig></COVER>
 </LOCAL>
 <LOCAL HOST="boss"><COVER><ScreenConfig><Screen name="0" comment="CONTROL" width="400" height="300" originY="1000"/></ScreenConfig></COVER></LOCAL>
 <LOCAL HOST="f1,s1"><COVER><ChannelConfig><Channel name="0" stereoMode="LEFT"/></ChannelConfig></COVER></LOCAL>
 <LOCAL HOST="f2,s2"><COVER><ChannelConfig><Channel name="0" stereoMode="RIGHT"/></ChannelConfig></COVER></LOCAL>
 <LOCAL HOST="s1,s2">
  <COVER><ScreenConfig><Screen name="0" width="3000"/></ScreenConfig>
   <WindowConfig><Window name="0" left="100" top="20" width="2000" height="1600"/></WindowConfig>
   <ViewportConfig><Viewport name="0" left="200" bottom="100" width="1500" height="1500"/></ViewportConfig></COVER>
 </LOCAL>
 <LOCAL HOST="guest"><COVER><ScreenConfig><Screen name="0"/></ScreenConfig></COVER></LOCAL>
 <CLUSTER MASTER="boss">
  <COVER>
   <FloorHeight value="-1500"/>
   <NumScreens value="1"/>
   <Stereo separation="62"/>
   <MultiPC><SyncMode hosts="s1,s2,f1,f2"/></MultiPC>
   <Input>
    <Device><Art driver="dtrack" port="5001"><Offset x="10" y="20" z="-1500"/><Orientation h="90" p="0" r="0"/></Art>
     <Old driver="flock"/></Device>
    <Body><Head device="Art" bodyIndex="2"><Offset x="0" y="-10" z="-100"/><Orientation h="0" p="-90" r="0"/></Head>
     <Wand device="Art" bodyIndex="F1"/></Body>
    <Persons><Person name="One" head="Head" hand="Wand"/></Persons>
   </Input>
  </COVER>
 </CLUSTER>
</COCONFIG>
)";

}  // namespace carom::test::cover

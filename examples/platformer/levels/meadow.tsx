<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" tiledversion="1.11.2" name="meadow" tilewidth="16" tileheight="16" tilecount="16" columns="8">
 <image source="meadow.png" width="128" height="32"/>
 <tile id="0" type="Solid"/>
 <tile id="1" type="Solid"/>
 <tile id="2" type="Solid"/>
 <tile id="3" type="OneWay"/>
 <tile id="4" type="Coin"/>
 <tile id="5" type="Kill"/>
 <tile id="6" type="Ladder"/>
 <tile id="7" type="Win"/>
 <tile id="12" type="Solid"/>
</tileset>

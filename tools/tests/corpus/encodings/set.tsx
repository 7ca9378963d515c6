<?xml version="1.0" encoding="UTF-8"?>
<tileset version="1.10" name="t" tilewidth="16" tileheight="16" tilecount="8" columns="4">
 <image source="t.png" width="64" height="32"/>
 <tile id="0" type="Solid"/><tile id="1" type="OneWay"/><tile id="2" type="Kill"/>
</tileset>
